#!/usr/bin/env bash
# Renders the pictures of tests/truth/pictures anew with Blender's Cycles; about 15 minutes on two cores. Needs root or
# sudo if Blender is not installed yet.
#   tests/truth/make_truth.sh [SAMPLES [ENVIRONMENTS [CASES]]]     names with commas between them, or all; see cases.json
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
truth=tests/truth

# numpy: for Blender's glTF importer.
packages=(blender python3-numpy)
if ! dpkg -s "${packages[@]}" >/dev/null 2>&1; then
  as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get install -y --no-install-recommends "${packages[@]}"
fi
deploy/fetch_assets.sh bunny >/dev/null
python3 "$truth/blender/environments.py" "$truth/environments"

# What Blender says is of interest only if it fails.
log=$(mktemp)
trap 'rm -f "$log"' EXIT
if ! nice blender -b --factory-startup --python-exit-code 1 -P "$truth/blender/make_truth.py" -- \
  "$truth/pictures" "${1:-512}" "${2:-all}" "${3:-all}" 2>&1 | tee "$log" | { grep --line-buffered '^truth:' || true; }
then
  tail -n 30 "$log" >&2
  exit 1
fi
