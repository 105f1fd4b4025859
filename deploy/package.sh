#!/usr/bin/env bash
# package.sh [DIR]: makes the Debian package and puts it into DIR (default: build/packages).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
target=${1:-build/packages}
cmake -S . -B build -G Ninja >/dev/null
cmake --build build --target amalgam_installed
mkdir -p "$target"
(cd build && cpack -G DEB -B packages)
[ "$(realpath "$target")" = "$(realpath build/packages)" ] || cp build/packages/*.deb "$target"
