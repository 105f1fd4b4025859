// The pinhole camera that a session is opened with. Pixel (0, 0) is the centre of the top left
// pixel, so the middle of the image is at ((width - 1) / 2, (height - 1) / 2).

const MAX_SIDE = 2048; // PROTOCOL.md, Limits

/**
 * @param {number} degrees horizontal field of view, above 0 and below 180
 * @returns {object} Hello.camera
 */
export function cameraFromFieldOfView(degrees, width, height) {
  const focal = width / 2 / Math.tan((degrees * Math.PI) / 360);
  const centre = { cx: (width - 1) / 2, cy: (height - 1) / 2 };
  return { width, height, fx: focal, fy: focal, ...centre, distortion: [] };
}

/** @returns {number} degrees */
export function fieldOfView({ width, fx }) {
  return (Math.atan(width / 2 / fx) * 360) / Math.PI;
}

/** @returns {{width: number, height: number}} the size that a camera's pictures are sent in */
export function sentSize(width, height) {
  const scale = Math.min(1, MAX_SIDE / Math.max(width, height));
  return { width: Math.round(width * scale), height: Math.round(height * scale) };
}
