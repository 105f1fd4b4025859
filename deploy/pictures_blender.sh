#!/usr/bin/env bash
# Makes the README's pictures of Blender anew: deploy/pictures/blender-*.webp. Needs a build, the demo's photograph
# (deploy/fetch_assets.sh), ImageMagick, Blender and a virtual screen: packages blender, python3-numpy, xvfb and xauth.
# BIN: where the programs are.
set -euo pipefail
[ $# -eq 0 ] || { echo "usage: deploy/pictures_blender.sh (takes no options)" >&2; exit 2; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bin=${BIN:-build/bin}
out=deploy/pictures
assets=out/assets
for program in blender xvfb-run convert; do
  command -v "$program" >/dev/null || { echo "pictures: $program is missing" >&2; exit 1; }
done
# Its name is seen in a picture.
work=$(mktemp -d)/desk
mkdir "$work"
trap 'rm -rf "$(dirname "$work")"' EXIT

# What Blender says is of interest only if a picture is missing.
xvfb-run -a -s "-screen 0 1120x700x24" blender --factory-startup --enable-event-simulate -p 0 0 1120 700 \
  -P deploy/pictures_blender.py -- "$work" >"$work/log" 2>&1 || true
for file in panel.png export.png desk.gltf; do
  [ -s "$work/$file" ] || { tail -n 30 "$work/log" >&2; exit 1; }
done

# Without the editors beside the view, and without the list of this machine's disks.
webp() { convert "$1" "${@:3}" +repage -strip -quality 80 "$out/blender-$2.webp"; }
webp "$work/panel.png" panel -crop 924x628+0+0
webp "$work/export.png" export -crop 872x660+248+28
"$bin/amalgam-inspect" "$work/desk.gltf"
"$bin/amalgam-render" --scene "$work/desk.gltf" --camera-image "$assets/singlemarkersoriginal.jpg" \
  --calibration "$assets/tutorial_camera_params.yml" --samples 9 --output "$work/composite.png"
webp "$work/composite.png" composite
ls -l "$out"/blender-*
