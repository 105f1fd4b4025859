// A lens as OpenCV's YAML, which `amalgam-client --calibration` and this page read.

function matrix(name, rows, columns, numbers) {
  return `${name}: !!opencv-matrix
   rows: ${rows}
   cols: ${columns}
   dt: d
   data: [ ${numbers.join(", ")} ]
`;
}

/**
 * @param {object} camera as Hello.camera, with k1, k2, p1 and p2
 * @param {number} error pixels, root mean square
 * @returns {string}
 */
export function toYaml({ width, height, fx, fy, cx, cy, distortion }, error) {
  return `%YAML:1.0
---
image_width: ${width}
image_height: ${height}
${matrix("camera_matrix", 3, 3, [fx, 0, cx, 0, fy, cy, 0, 0, 1])}${matrix(
    "distortion_coefficients",
    5,
    1,
    [...distortion, 0],
  )}avg_reprojection_error: ${error}
`;
}
