#!/usr/bin/env bash
# Installs what is missing, builds with warnings as errors, runs all tests, checks the formatting. The bunnies are tested
# if they can be fetched.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

deploy/install.sh
deploy/build.sh
deploy/fetch_assets.sh bunny
ctest --test-dir build --output-on-failure --no-tests=error -j "$(nproc)"

echo "formatting:"
git ls-files '*.cpp' '*.h' | xargs clang-format --dry-run -Werror
echo "all files are formatted"
