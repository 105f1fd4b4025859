// Saves what the canvas shows, one picture or a film, and other files.

const TYPES = ["video/mp4;codecs=avc1.42E01E", "video/webm;codecs=vp9", "video/webm"];

export function saveFile(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The browser has taken the blob over when it begins to save it.
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

/** @returns {string} as "amalgam-2024-05-06-07.08.09.png" */
function fileName(extension) {
  const now = new Date();
  const local = new Date(now.getTime() - now.getTimezoneOffset() * 60000).toISOString();
  return `amalgam-${local.slice(0, 19).replace("T", "-").replaceAll(":", ".")}.${extension}`;
}

/** @param {HTMLCanvasElement} canvas */
export async function saveSnapshot(canvas) {
  const blob = await new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
  if (blob) saveFile(blob, fileName("png"));
}

export class FilmRecorder {
  #recorder = null;

  static get isSupported() {
    return typeof MediaRecorder !== "undefined";
  }

  get isRecording() {
    return this.#recorder !== null;
  }

  /** @param {HTMLCanvasElement} canvas */
  start(canvas) {
    const mimeType = TYPES.find((type) => MediaRecorder.isTypeSupported(type));
    const recorder = new MediaRecorder(canvas.captureStream(), mimeType ? { mimeType } : {});
    const chunks = [];
    recorder.ondataavailable = ({ data }) => chunks.push(data);
    recorder.onstop = () => {
      const type = recorder.mimeType.split(";")[0];
      saveFile(new Blob(chunks, { type }), fileName(type === "video/mp4" ? "mp4" : "webm"));
    };
    recorder.start();
    this.#recorder = recorder;
  }

  /** Ends the film and saves it. */
  stop() {
    this.#recorder?.stop();
    this.#recorder = null;
  }
}
