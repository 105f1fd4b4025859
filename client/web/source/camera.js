// The browser's camera: which there are, one of them opened, and why that failed.

/** An Error whose reason is a key of words.js: "insecure", "denied", "none", "busy" or "failed". */
export class CameraError extends Error {
  constructor(reason, detail = "") {
    super(detail);
    this.reason = reason;
  }
}

const REASONS = {
  NotAllowedError: "denied",
  SecurityError: "denied",
  NotFoundError: "none",
  OverconstrainedError: "none",
  NotReadableError: "busy",
  AbortError: "busy",
};

/**
 * Opens a camera and plays it in the video element.
 * @param {HTMLVideoElement} video
 * @param {{deviceId: string, width: number, height: number}} wanted deviceId "": any, preferably
 *   one that looks away from the user. The camera takes the nearest size that it has.
 * @returns {Promise<MediaStream>} or a CameraError
 */
export async function openCamera(video, { deviceId, width, height }) {
  // Browsers hide cameras from pages that came neither by HTTPS nor from this machine.
  if (!navigator.mediaDevices) throw new CameraError("insecure");
  const size = { width: { ideal: width }, height: { ideal: height } };
  const which = deviceId ? { deviceId: { exact: deviceId } } : { facingMode: "environment" };
  try {
    const stream = await navigator.mediaDevices.getUserMedia({ video: { ...size, ...which } });
    video.srcObject = stream;
    await video.play();
    return stream;
  } catch (error) {
    // A remembered camera may be unplugged: then any other will do.
    if (deviceId && ["OverconstrainedError", "NotFoundError"].includes(error.name)) {
      return openCamera(video, { deviceId: "", width, height });
    }
    throw new CameraError(REASONS[error.name] ?? "failed", error.message);
  }
}

export function closeCamera(video) {
  video.srcObject?.getTracks().forEach((track) => track.stop());
  video.srcObject = null;
}

/** @returns {Promise<{deviceId: string, label: string}[]>} names come only with a permission */
export async function listCameras() {
  const devices = (await navigator.mediaDevices?.enumerateDevices()) ?? [];
  return devices
    .filter(({ kind }) => kind === "videoinput")
    .map(({ deviceId, label }, i) => ({ deviceId, label: label || `Camera ${i + 1}` }));
}

/**
 * Calls back for each new frame of the video, with the time of its capture on performance.now()'s
 * clock, as far as the browser knows it.
 */
export function onEachFrame(video, callback) {
  if (!video.requestVideoFrameCallback) {
    const loop = (now) => {
      if (video.readyState >= HTMLMediaElement.HAVE_CURRENT_DATA) callback(now);
      requestAnimationFrame(loop);
    };
    requestAnimationFrame(loop);
    return;
  }
  const loop = (now, { captureTime }) => {
    video.requestVideoFrameCallback(loop);
    callback(captureTime ?? now);
  };
  video.requestVideoFrameCallback(loop);
}
