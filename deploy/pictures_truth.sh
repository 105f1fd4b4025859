# Part of pictures.sh: composites beside the path-traced truth (tests/truth) and beside the thesis's method.
python3 - "$work/truth" <<'PYTHON'
import json
import sys

camera = json.load(open("tests/truth/cases.json"))["camera"]
json.dump({"poses": [camera["pose"]]}, open(sys.argv[1] + "-poses.json", "w"))
with open(sys.argv[1] + "-camera.yml", "w") as file:
    file.write(f"""%YAML:1.0
---
image_width: {camera["width"]}
image_height: {camera["height"]}
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [{camera["focal"]}, 0., {camera["cx"]}, 0., {camera["focal"]}, {camera["cy"]}, 0., 0., 1.]
distortion_coefficients: !!opencv-matrix
   rows: 1
   cols: 5
   dt: d
   data: [0., 0., 0., 0., 0.]
""")
PYTHON
# truth_row CASE SCENE: the truth, ours with 64 lights, and the thesis's.
truth_row() {
  local pair="tests/truth/pictures/$1-room-full-linear"
  local seen=(--scene "deploy/scenes/$2.gltf" --camera-image "$pair-camera.png" --calibration "$work/truth-camera.yml"
    --poses "$work/truth-poses.json")
  render "${seen[@]}" --env-lights median-cut:64 --output "$work/$1-ours.png"
  render "${seen[@]}" --meter grey --tone-map reinhard --real-surfaces difference --output "$work/$1-thesis.png"
  convert "$pair-truth.png" "$work/$1-ours.png" "$work/$1-thesis.png" +append "$work/$1-row.png"
}
truth_row complex complex
truth_row slate-and-blue diffuse
convert "$work"/{complex,slate-and-blue}-row.png -append -filter point -resize 200% "$out/against-truth.png"
