// Reads a camera's calibration: OpenCV's YAML, JSON and XML, and ROS's and Kalibr's YAML. The native
// client reads the same (client/tracking/calibration_file.cpp) and scales them in the same way.
import { DEFAULT_SCHEMA, load, Type } from "js-yaml";
import { parseXml } from "./calibration_xml.js";

const opencvTypes = ["opencv-matrix", "opencv-nd-matrix"].map(
  (name) => new Type(`tag:yaml.org,2002:${name}`, { kind: "mapping", construct: (map) => map }),
);
const schema = DEFAULT_SCHEMA.extend(opencvTypes);

const MATRIX = [
  "camera_matrix",
  "cameraMatrix",
  "Camera_Matrix",
  "camera_Matrix",
  "CameraMatrix",
  "intrinsic_matrix",
  "mtx",
  "K",
  "k",
];
const DISTORTION = [
  "distortion_coefficients",
  "Distortion_Coefficients",
  "distortion_coeffs",
  "distCoeffs",
  "dist_coeffs",
  "dist_coeff",
  "distCoeff",
  "dist_coefs",
  "dist",
  "D",
  "d",
];
const WIDTH = ["image_width", "image_Width", "imageWidth", "width"];
const HEIGHT = ["image_height", "image_Height", "imageHeight", "height"];
const MAX_COEFFICIENTS = 12; // of the protocol; OpenCV's two more are of a tilted sensor

const first = (root, names) => names.map((name) => root[name]).find((node) => node !== undefined);

// A list, a list of rows, or a map of rows, cols and data.
function numbers(node, what) {
  const list = Array.isArray(node) ? node : node?.data;
  if (!Array.isArray(list)) throw new Error(`The file's ${what} is not a matrix.`);
  const flat = list.flat(2).map(Number);
  if (!flat.every(Number.isFinite))
    throw new Error(`The file's ${what} has something but numbers.`);
  return flat;
}

function parse(text) {
  try {
    if (text.trimStart().startsWith("{")) return JSON.parse(text);
    if (text.trimStart().startsWith("<")) return parseXml(text);
    // OpenCV's head, "%YAML:1.0", is not YAML.
    return load(text.replace(/^%YAML.*$/m, ""), { schema });
  } catch (error) {
    throw new Error(`The file is neither YAML nor JSON nor XML (${error.message.split("\n")[0]}).`);
  }
}

function kalibr({ intrinsics, distortion_coeffs: distortion, ...camera }) {
  if (camera.camera_model !== "pinhole" || camera.distortion_model !== "radtan") {
    throw new Error("Of Kalibr's lens models only pinhole with radtan is supported.");
  }
  const [fx, fy, cx, cy] = numbers(intrinsics, "intrinsics");
  const [width, height] = camera.resolution ?? [0, 0];
  return { width, height, fx, fy, cx, cy, distortion: numbers(distortion, "distortion_coeffs") };
}

function flat(root) {
  const matrix = first(root, MATRIX);
  if (matrix === undefined)
    throw new Error("The file has no camera matrix (camera_matrix, K, ...).");
  const distortion = first(root, DISTORTION);
  if (distortion === undefined) {
    throw new Error("The file has no distortion coefficients (distortion_coefficients, D, ...).");
  }
  const fisheye = Number(root.fisheye_model ?? 0) !== 0;
  const models = ["", "plumb_bob", "rational_polynomial"];
  if (fisheye || !models.includes(root.distortion_model ?? "")) {
    throw new Error("The file's lens model is not supported: only OpenCV's pinhole camera is.");
  }
  const k = numbers(matrix, "camera matrix");
  if (k.length !== 9) throw new Error(`The file's camera matrix has ${k.length} numbers, not 9.`);
  return {
    width: Number(first(root, WIDTH) ?? 0),
    height: Number(first(root, HEIGHT) ?? 0),
    fx: k[0],
    fy: k[4],
    cx: k[2],
    cy: k[5],
    distortion: numbers(distortion ?? [], "distortion coefficients"),
  };
}

/**
 * @param {string} text of the file
 * @returns {object} as Hello.camera; width and height are 0 if the file does not say. Throws an
 *   Error in plain words.
 */
export function parseCalibration(text) {
  const root = parse(text);
  if (typeof root !== "object" || root === null || Array.isArray(root)) {
    throw new Error("The file is no camera calibration.");
  }
  const camera = root.cam0 ? kalibr(root.cam0) : flat(root);
  if (!(camera.fx > 0 && camera.fy > 0))
    throw new Error("The file's focal lengths are not positive.");
  if (camera.distortion.slice(MAX_COEFFICIENTS).some((value) => value !== 0)) {
    throw new Error("A tilted sensor (distortion coefficients 13 and 14) is not supported.");
  }
  return { ...camera, distortion: camera.distortion.slice(0, MAX_COEFFICIENTS) };
}

/**
 * @param {object} calibration from parseCalibration()
 * @returns {object} the same camera taking images of another size; throws if that is a crop
 */
export function fitToImage(calibration, width, height) {
  if (!calibration.width || !calibration.height) return { ...calibration, width, height };
  const sx = width / calibration.width;
  const sy = height / calibration.height;
  if (Math.abs(calibration.height * sx - height) > 1) {
    const of = `${calibration.width}x${calibration.height}`;
    throw new Error(
      `The calibration is for ${of}, and the camera's ${width}x${height} is a crop of it.`,
    );
  }
  return {
    ...calibration,
    width,
    height,
    fx: calibration.fx * sx,
    fy: calibration.fy * sy,
    // Lengths scale about the image's corner, half a pixel before the first pixel's centre.
    cx: (calibration.cx + 0.5) * sx - 0.5,
    cy: (calibration.cy + 0.5) * sy - 0.5,
  };
}
