#!/usr/bin/env bash
# Makes the pictures of the README anew, by our own renderer: deploy/pictures/*.jpg. Needs a build and the demo's assets.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
out=deploy/pictures
assets=out/assets
mkdir -p "$out"
photo=(--camera-image "$assets/singlemarkersoriginal.jpg" --calibration "$assets/tutorial_camera_params.yml" --samples 9)
render() { build/bin/amalgam-render "$@"; }

render --scene deploy/scenes/complex.gltf "${photo[@]}" --output "$out/complex-photograph.jpg"
render --scene deploy/scenes/generated/bunny-glass.gltf "${photo[@]}" --output "$out/bunny-glass-photograph.jpg"
render --scene deploy/scenes/generated/bunny-mirror.gltf "${photo[@]}" --output "$out/bunny-mirror-photograph.jpg"
render --scene deploy/scenes/diffuse.gltf "${photo[@]}" --output "$out/diffuse-photograph.jpg"

# The synthetic camera, by way of server and client.
build/bin/amalgam-server --samples 9 --listen 127.0.0.1:0 --admin 127.0.0.1:0 --log-level warn > out/pictures-server.txt &
server=$!
trap 'kill -TERM $server 2>/dev/null || true' EXIT
for _ in $(seq 300); do grep -q listening out/pictures-server.txt && break; sleep 0.1; done
address=$(sed -n 's/^listening on \([^ ]*\) .*/\1/p' out/pictures-server.txt)
build/bin/amalgam-client --server "$address" --synthetic --frames 10 --lockstep --output out/pictures >/dev/null
cp out/pictures/frame-000010.jpg "$out/complex-synthetic.jpg"
ls -l "$out"
