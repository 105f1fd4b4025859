#!/usr/bin/env bash
# Configures and builds everything into build/, warnings as errors. Options go to cmake.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
cmake -S . -B build -G Ninja "$@" >/dev/null
cmake --build build
