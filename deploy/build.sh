#!/usr/bin/env bash
# Configures and builds into build/, warnings as errors: everything, or the targets in BUILD_TARGETS. Options go to cmake.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
cmake -S . -B build -G Ninja "$@" >/dev/null
read -ra targets <<< "${BUILD_TARGETS:-all}"
cmake --build build --target "${targets[@]}"
