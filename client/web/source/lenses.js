// Lenses that were measured in this browser, by camera and size of its pictures. The browser's
// names for cameras stay the same for one site.

const KEY = "amalgam-lenses";
const MOST = 20; // the oldest ones go

const nameOf = (deviceId, width, height) => `${deviceId} ${width}x${height}`;

/** @returns {[string, {text: string, error: number}][]} what was saved and still makes sense */
function parse(text) {
  try {
    const list = JSON.parse(text);
    return list.filter(([name, lens]) => typeof name === "string" && typeof lens.text === "string");
  } catch {
    return [];
  }
}

export class Lenses {
  #storage;

  /** @param {Storage | null} storage null: nothing is remembered beyond this page */
  constructor(storage) {
    this.#storage = storage;
    this.list = this.#read();
  }

  /** @returns {{text: string, error: number} | null} text: OpenCV's YAML; error: pixels */
  find(deviceId, width, height) {
    const name = nameOf(deviceId, width, height);
    return this.list.find(([known]) => known === name)?.[1] ?? null;
  }

  keep(deviceId, width, height, lens) {
    const name = nameOf(deviceId, width, height);
    this.#write([[name, lens], ...this.list.filter(([known]) => known !== name)].slice(0, MOST));
  }

  forget(deviceId, width, height) {
    const name = nameOf(deviceId, width, height);
    this.#write(this.list.filter(([known]) => known !== name));
  }

  #read() {
    try {
      return parse(this.#storage?.getItem(KEY));
    } catch {
      return []; // the browser forbids it
    }
  }

  #write(list) {
    this.list = list;
    try {
      this.#storage?.setItem(KEY, JSON.stringify(list));
    } catch {
      // The browser forbids it, or there is no room: it is known until the page is closed.
    }
  }
}

/** @returns {Storage | null} */
export function localStorageOrNone() {
  try {
    return localStorage;
  } catch {
    return null;
  }
}
