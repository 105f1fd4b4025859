#!/usr/bin/env bash
# Makes the pictures of the README anew, by our own renderer: deploy/pictures/, with two films, complex-synthetic.webp
# and page-film.webp. Needs a build, the demo's assets (deploy/fetch_assets.sh) and ImageMagick, which cuts and joins; the
# page's pictures also need Chromium. Some pictures show test data that the repository does not hold; without it they are
# named and stay as they are. BIN: where the programs are.
set -euo pipefail
[ $# -eq 0 ] || { echo "usage: deploy/pictures.sh: makes the files in deploy/pictures anew (takes no options)" >&2; exit 2; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bin=${BIN:-build/bin}
out=deploy/pictures
work=out/pictures
data=${AMALGAM_TEST_DATA:-../shared/data}
assets=out/assets
mkdir -p "$out" "$work"
command -v convert >/dev/null || { echo "pictures: convert (package imagemagick) is missing" >&2; exit 1; }

photo=(--camera-image "$assets/singlemarkersoriginal.jpg" --calibration "$assets/tutorial_camera_params.yml")
# The same photograph at twice the size, so that there is something to see of small objects.
convert "$assets/singlemarkersoriginal.jpg" -resize 200% -quality 95 "$work/photo.jpg"
sed '1a image_width: 640\nimage_height: 480' "$assets/tutorial_camera_params.yml" > "$work/photo.yml"
large=(--camera-image "$work/photo.jpg" --calibration "$work/photo.yml" --samples 9)

render() { "$bin/amalgam-render" "$@"; }
# jpeg IN OUT [ImageMagick's options]: OUT is the name in the gallery, without ending.
jpeg() { convert "$1" "${@:3}" +repage -strip -quality 88 "$out/$2.jpg"; }
# have FILE...: whether all test data that a picture needs are there.
have() {
  local file
  for file in "$@"; do
    [ -e "$data/$file" ] || { echo "pictures: no $data/$file; its picture stays as it is" >&2; return 1; }
  done
}

for part in scenes methods clients film page truth status; do
  # shellcheck source=/dev/null
  source "deploy/pictures_$part.sh"
done
ls -l "$out"
