#!/usr/bin/env bash
# Builds with sanitizers and runs tests: deploy/sanitize.sh asan|tsan [ctest options]. Takes half an hour on two cores.
#   asan: memory errors, leaks of our own, undefined behaviour. The long comparisons (parity, numerics, golden) are left
#         out unless options are given.
#   tsan: data races, in the programs that test the network, the client's link, logging and the renderer's scheduling.
#         Tests fail by a report only, not because everything is ten times slower: with options they fail as usual.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
kind=${1:-}
[[ $kind == asan || $kind == tsan ]] || { echo "usage: deploy/sanitize.sh asan|tsan [ctest options]" >&2; exit 2; }
shift

# What has threads of ours. The other programs' threads are those of libraries that are not instrumented.
threaded=(protocol_test net_test network_test web_test unit_common load_test client_test faults_test turns_test)
cmake --preset "$kind" >/dev/null
if [ "$kind" = tsan ]; then
  cmake --build --preset tsan --target "${threaded[@]}"
else
  cmake --build --preset asan
fi

# Mesa and TBB keep memory until the process ends, and llvmpipe's threads are not instrumented.
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=0:strict_string_checks=1}
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1:halt_on_error=1}
reported=66 # no other test ends like this
export TSAN_OPTIONS=${TSAN_OPTIONS:-halt_on_error=1:exitcode=$reported:second_deadlock_stack=1:suppressions=$PWD/deploy/tsan.supp}
if [ "$kind" = asan ] || [ $# -gt 0 ]; then
  [ $# -gt 0 ] || set -- -LE 'parity|numerics|golden'
  exec ctest --test-dir "build/$kind" --output-on-failure --no-tests=error -j "$(nproc)" "$@"
fi

status=0
for program in "${threaded[@]}"; do
  log=build/tsan/$program.log
  ended=0
  "build/tsan/bin/$program" > "$log" 2>&1 || ended=$?
  tests=$(sed -n 's/^\[==========\] \([0-9]*\) tests.* ran\..*/\1/p' "$log")
  if (( ended == reported )); then
    echo "$program: a report, see $log"
    grep -m 3 -A 12 'WARNING: ThreadSanitizer' "$log" || true
    status=1
  elif [ -z "$tests" ]; then
    echo "$program: ended with $ended, see $log"
    status=1
  else
    echo "$program: $tests tests, no report; $(grep -c '^\[  FAILED  \].*ms)$' "$log" || true) failed, by their times or memory"
  fi
done
exit "$status"
