import assert from "node:assert/strict";
import { test } from "node:test";
import { fitToImage, parseCalibration } from "amalgam-page/calibration.js";
import { cameraFromFieldOfView, fieldOfView, sentSize } from "amalgam-page/camera_model.js";

const OPENCV = `%YAML:1.0
---
calibration_time: "Wed 08 Dec 2021 05:13:09 PM MSK"
image_width: 640
image_height: 480
flags: 0
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 628.158, 0., 324.099, 0., 628.156,
       260.908, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ 0.0995485, -0.206384, 0.00754589, 0.00336531, 0 ]
`;

test("OpenCV's YAML is read", () => {
  assert.deepEqual(parseCalibration(OPENCV), {
    width: 640,
    height: 480,
    fx: 628.158,
    fy: 628.156,
    cx: 324.099,
    cy: 260.908,
    distortion: [0.0995485, -0.206384, 0.00754589, 0.00336531, 0],
  });
});

test("OpenCV's JSON, ROS's and Kalibr's YAML are read", () => {
  const json = {
    image_width: 640,
    image_height: 480,
    camera_matrix: {
      type_id: "opencv-matrix",
      rows: 3,
      cols: 3,
      dt: "d",
      data: [600, 0, 320, 0, 601, 240, 0, 0, 1],
    },
    distortion_coefficients: { rows: 1, cols: 2, data: [0.1, 0.2] },
  };
  assert.equal(parseCalibration(JSON.stringify(json)).fy, 601);
  const ros = `image_width: 640
image_height: 480
camera_matrix: {rows: 3, cols: 3, data: [600, 0, 320, 0, 602, 240, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0.1, 0, 0, 0, 0]}`;
  assert.equal(parseCalibration(ros).fy, 602);
  const kalibr = `cam0:
  camera_model: pinhole
  intrinsics: [600, 603, 320, 240]
  distortion_model: radtan
  distortion_coeffs: [0.1, 0, 0, 0]
  resolution: [640, 480]`;
  assert.deepEqual([parseCalibration(kalibr).fy, parseCalibration(kalibr).width], [603, 640]);
});

test("what cannot be used is said in words", () => {
  const cases = [
    ["{", /neither YAML nor JSON nor XML/],
    ["just text", /no camera calibration/],
    ["a: 1", /no camera matrix/],
    ["K: [600, 0, 320, 0, 600, 240, 0, 0, 1]", /no distortion/],
    ["K: [1, 2]\nD: []", /2 numbers/],
    ["K: [-600, 0, 320, 0, 600, 240, 0, 0, 1]\nD: []", /not positive/],
    ["K: [600, 0, x, 0, 600, 240, 0, 0, 1]\nD: []", /something but numbers/],
    ["K: [600, 0, 3, 0, 600, 2, 0, 0, 1]\nD: [0,0,0,0,0,0,0,0,0,0,0,0,0.1,0]", /tilted/],
    ["K: [600, 0, 3, 0, 600, 2, 0, 0, 1]\nD: []\ndistortion_model: equidistant", /lens model/],
  ];
  for (const [text, words] of cases) assert.throws(() => parseCalibration(text), words, text);
});

test("another size scales about the image's corner, not about a pixel's centre", () => {
  const half = fitToImage(parseCalibration(OPENCV), 320, 240);
  assert.equal(half.fx, 314.079);
  assert.ok(Math.abs(half.cx - 161.7995) < 1e-9);
  assert.ok(Math.abs(half.cy - 130.204) < 1e-9);
  assert.throws(() => fitToImage(parseCalibration(OPENCV), 640, 360), /crop/);
});

test("60 degrees over 640 pixels are a focal length of 554", () => {
  const camera = cameraFromFieldOfView(60, 640, 480);
  assert.ok(Math.abs(camera.fx - 320 * Math.sqrt(3)) < 1e-9);
  assert.deepEqual([camera.cx, camera.cy], [319.5, 239.5]);
  assert.ok(Math.abs(fieldOfView(camera) - 60) < 1e-9);
});

test("pictures that are too large for the server are made smaller, in their shape", () => {
  assert.deepEqual(sentSize(640, 480), { width: 640, height: 480 });
  assert.deepEqual(sentSize(4096, 2160), { width: 2048, height: 1080 });
});
