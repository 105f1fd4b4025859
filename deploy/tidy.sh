#!/usr/bin/env bash
# Runs clang-tidy (.clang-tidy) on what changed since a commit: deploy/tidy.sh [COMMIT], by default the one before this
# one; "all" takes every source. A source takes 5 to 10 s; of more than TIDY_MOST (20) only those that changed most are
# taken. Ends with 1 if it finds anything.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
since=${1:-HEAD~1}
most=${TIDY_MOST:-20}

if [ "$since" = all ]; then
  mapfile -t files < <(git ls-files '*.cpp')
  most=${#files[@]}
elif git rev-parse --verify --quiet "$since" >/dev/null; then
  mapfile -t files < <(git diff --numstat --no-renames --diff-filter=d "$since" -- '*.cpp' | sort -rn | cut -f 3)
else
  echo "tidy: there is no commit $since to compare with, so nothing is checked"
  exit 0
fi
if [ ${#files[@]} -eq 0 ]; then
  echo "tidy: no source changed since $since"
  exit 0
fi
# A build folder of its own: clang cannot read GCC's precompiled headers.
cmake --preset tidy >/dev/null
cmake --build build/tidy --target protocol/generated/protocol/amalgam.pb.h \
  protocol/generated/protocol/session_record.pb.h >/dev/null
echo "tidy: ${#files[@]} sources changed since $since, $((${#files[@]} < most ? ${#files[@]} : most)) looked at"
files=("${files[@]:0:most}")
printf '%s\0' "${files[@]}" |
  xargs -0 -P "$(nproc)" -n 1 clang-tidy -p build/tidy --quiet --warnings-as-errors='*' 2>/dev/null
