#!/usr/bin/env bash
# Fetches what the demo shows and the repository does not hold, from Debian packages that are unpacked but not installed:
# the 69,666-triangle bunny (glmark2-data, 7 MB) and a photograph of markers with its calibration (opencv-doc, 96 MB).
# What is there already is not fetched again. A package that cannot be had is named, and what wants it goes on without.
#   deploy/fetch_assets.sh [bunny] [photograph]      both, if neither is said
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
assets=out/assets
generated=deploy/scenes/generated
mkdir -p "$assets" "$generated"

# unpack PACKAGE PATTERN DESTINATION: the first file of the package that matches.
unpack() {
  local package=$1 pattern=$2 destination=$3 folder found
  [ -s "$destination" ] && return 0
  folder=$(mktemp -d)
  if ls "$assets/$package"_*.deb >/dev/null 2>&1 || (cd "$assets" && apt-get download -qq "$package" >/dev/null 2>&1); then
    dpkg-deb --fsys-tarfile "$assets/$package"_*.deb | tar -x -C "$folder" --wildcards "$pattern" 2>/dev/null || true
    found=$(find "$folder" -type f | sort | head -n 1)
    if [ -n "$found" ]; then
      case "$found" in *.gz) gunzip -c "$found" > "$destination" ;; *) cp "$found" "$destination" ;; esac
    fi
  fi
  rm -rf "$folder"
  [ -s "$destination" ] || { echo "assets: no $pattern in package $package" >&2; return 1; }
}

[ $# -gt 0 ] || set -- bunny photograph
for part in "$@"; do
  case "$part" in
    bunny) unpack glmark2-data '*/models/bunny.obj' "$assets/bunny.obj" || true ;;
    photograph)
      unpack opencv-doc '*/singlemarkersoriginal.jpg' "$assets/singlemarkersoriginal.jpg" || true
      unpack opencv-doc '*/tutorial_camera_params.yml*' "$assets/tutorial_camera_params.yml" || true
      ;;
    *) echo "assets: '$part' is neither bunny nor photograph" >&2; exit 2 ;;
  esac
done
rm -f "$assets"/*.deb

# The scenes that are there already need it as much as new ones, and that of an earlier version would be refused.
cp deploy/scenes/environment.exr "$generated/environment.exr"
for material in glass mirror; do
  if [ -s "$assets/bunny.obj" ] && [ ! -s "$generated/bunny-$material.gltf" ]; then
    python3 deploy/scenes/wrap_obj.py "$assets/bunny.obj" --material "$material" --output "$generated/bunny-$material.gltf"
  fi
done
ls "$assets" "$generated"
