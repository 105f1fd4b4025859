// The card over the picture that says what is wrong or awaited, with a button where there is
// something to do. Screen readers are told once; the seconds that run down are outside of what they
// are told.
import { countDown } from "./words.js";

const TICK_MS = 250;
const ACTIONS = { retry: "Try now", start: "Start the camera", settings: "Open the settings" };

export class Notice {
  #parts;
  #shown = "";
  #timer = null;
  #action = null;

  /**
   * @param {Record<"card" | "title" | "text" | "countdown" | "action", HTMLElement>} parts
   * @param {Record<string, () => void>} actions what each key of ACTIONS does
   */
  constructor(parts, actions) {
    this.#parts = parts;
    this.#action = "start";
    parts.action.addEventListener("click", () => actions[this.#action]?.());
  }

  /**
   * @param {object | null} notice of words.js
   * @param {number} [retryAt] of Date.now()
   */
  show(notice, retryAt) {
    const key = JSON.stringify([notice, retryAt]);
    if (key === this.#shown) return;
    this.#shown = key;
    clearInterval(this.#timer);
    const { card, title, text, countdown, action } = this.#parts;
    card.hidden = notice === null;
    if (notice === null) return;
    card.dataset.level = notice.level;
    card.toggleAttribute("data-prints", notice.prints === true);
    title.textContent = notice.title;
    text.textContent = notice.text;
    this.#action = notice.action;
    action.hidden = !notice.action;
    action.textContent = ACTIONS[notice.action] ?? "";
    const tick = () => {
      countdown.textContent = countDown(retryAt, Date.now());
    };
    tick();
    if (retryAt !== undefined) this.#timer = setInterval(tick, TICK_MS);
  }
}
