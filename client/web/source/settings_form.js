// The form of the settings: shows them, and gives them back when they are applied.
import { parseCalibration } from "./calibration.js";
import { fieldOfView } from "./camera_model.js";
import { listCameras } from "./camera.js";

const element = (id) => document.getElementById(id);

export class SettingsForm {
  #calibration = null;
  #lens = null; // {camera, error}: measured and in use

  /**
   * @param {object} settings of settings.js
   * @param {(settings: object) => void} apply called with all of them when some were changed
   */
  constructor(settings, apply) {
    this.#fill(settings);
    element("fov").addEventListener("input", () => this.#say());
    element("quality").addEventListener("input", () => this.#say());
    element("calibration").addEventListener("change", () => this.#readCalibration());
    element("calibration-clear").addEventListener("click", () => this.forgetFile());
    element("settings").addEventListener("submit", (event) => {
      event.preventDefault();
      apply(this.values());
    });
  }

  /** @returns {object} the settings that this form has */
  values() {
    return {
      deviceId: element("device").value,
      size: element("size").value,
      fieldOfView: Number(element("fov").value),
      calibration: this.#calibration,
      server: element("server").value,
      quality: Number(element("quality").value),
      steady: element("steady").checked,
      token: element("token").value,
    };
  }

  /** Lists the cameras anew: their names come only after the permission. */
  async listCameras(current) {
    const cameras = await listCameras();
    const options = cameras.map(({ deviceId, label }) => new Option(label, deviceId));
    element("device").replaceChildren(new Option("any", ""), ...options);
    element("device").value = cameras.some(({ deviceId }) => deviceId === current) ? current : "";
  }

  /** @param {{camera: object, error: number} | null} lens that was measured and is in use */
  showLens(lens) {
    this.#lens = lens;
    this.#say();
  }

  /** The calibration file that was chosen. */
  forgetFile() {
    this.#setCalibration(null);
  }

  #fill(settings) {
    element("device").append(new Option("as last time", settings.deviceId));
    element("device").value = settings.deviceId;
    element("size").value = settings.size;
    element("fov").value = settings.fieldOfView;
    element("server").value = settings.server;
    element("server").placeholder = location.host;
    element("quality").value = settings.quality;
    element("steady").checked = settings.steady;
    element("token").value = settings.token;
    this.#setCalibration(settings.calibration);
  }

  #say() {
    element("fov-value").textContent = `${element("fov").value}°`;
    element("quality-value").textContent = `${element("quality").value} %`;
    element("fov").disabled = this.#calibration !== null || this.#lens !== null;
    element("lens-state").hidden = this.#lens === null;
    element("lens-forget").hidden = this.#lens === null;
    if (!this.#lens) return;
    const { camera, error } = this.#lens;
    const degrees = fieldOfView(camera).toFixed(1);
    element("lens-state").textContent =
      `Measured for this camera and size: ${degrees}° wide, to ${error.toFixed(2)} pixels.`;
  }

  async #readCalibration() {
    const file = element("calibration").files[0];
    if (!file) return;
    this.#setCalibration({ name: file.name, text: await file.text() });
  }

  #setCalibration(calibration) {
    const state = element("calibration-state");
    state.classList.remove("error");
    state.textContent = "";
    this.#calibration = calibration;
    if (calibration) {
      try {
        const camera = parseCalibration(calibration.text);
        const view = camera.width ? `, ${fieldOfView(camera).toFixed(1)}° wide` : "";
        state.textContent = `${calibration.name}: fx ${camera.fx.toFixed(1)}${view}`;
      } catch (error) {
        this.#calibration = null;
        state.classList.add("error");
        state.textContent = `${calibration.name}: ${error.message}`;
      }
    }
    element("calibration").value = "";
    element("calibration-clear").hidden = this.#calibration === null;
    this.#say();
  }
}
