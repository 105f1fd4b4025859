#!/usr/bin/env bash
# Runs clang-tidy (.clang-tidy) on what changed since a commit: deploy/tidy.sh [COMMIT], by default the one before this
# one; "all" takes every source. Ends with 1 if it finds anything.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
since=${1:-HEAD~1}

if [ "$since" = all ]; then
  mapfile -t files < <(git ls-files '*.cpp')
elif git rev-parse --verify --quiet "$since" >/dev/null; then
  mapfile -t files < <(git diff --name-only --diff-filter=d "$since" -- '*.cpp')
else
  echo "tidy: there is no commit $since to compare with, so nothing is checked"
  exit 0
fi
if [ ${#files[@]} -eq 0 ]; then
  echo "tidy: no source changed since $since"
  exit 0
fi
database=build
[ -f $database/compile_commands.json ] || { cmake --preset tidy >/dev/null; database=build/tidy; }
echo "tidy: ${#files[@]} files changed since $since"
printf '%s\0' "${files[@]}" |
  xargs -0 -P "$(nproc)" -n 1 clang-tidy -p $database --quiet --warnings-as-errors='*' 2>/dev/null
