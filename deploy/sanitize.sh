#!/usr/bin/env bash
# Builds with sanitizers and runs the tests: deploy/sanitize.sh asan|tsan [ctest options]. Takes half an hour on two
# cores; the long comparisons (parity, numerics, golden) are left out unless options are given.
#   asan: memory errors, leaks of our own, undefined behaviour
#   tsan: data races, in the network, the client and the renderer's threads
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
kind=${1:-}
[[ $kind == asan || $kind == tsan ]] || { echo "usage: deploy/sanitize.sh asan|tsan [ctest options]" >&2; exit 2; }
shift

cmake --preset "$kind" >/dev/null
cmake --build --preset "$kind"

# Mesa and TBB keep memory until the process ends, and llvmpipe's threads are not instrumented.
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=0:strict_string_checks=1}
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1:halt_on_error=1}
export TSAN_OPTIONS=${TSAN_OPTIONS:-halt_on_error=1:second_deadlock_stack=1:suppressions=$PWD/deploy/tsan.supp}
if [ "$kind" = tsan ]; then
  defaults=(-R 'Session|Server|Connection|Viewer|Mailbox|RenderThread|WriteSlot|Operation|Conversation')
else
  defaults=(-LE 'parity|numerics|golden')
fi
ctest --test-dir "build/$kind" --output-on-failure --no-tests=error -j "$(nproc)" "${@:-${defaults[@]}}"
