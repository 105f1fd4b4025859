#!/usr/bin/env bash
# Looks for bytes that break what reads them: deploy/fuzz.sh MINUTES [TARGET ...]. Builds the targets of tests/fuzz
# (all, if none is named) with clang's libFuzzer, AddressSanitizer and UndefinedBehaviorSanitizer, shares the minutes
# among them. Prints the number of runs of each. Ends with 1 if something was found: the bytes are then in
# build/fuzz/findings, and `build/fuzz/bin/fuzz_TARGET FILE` runs them again. What was tried stays in build/fuzz/tried,
# so that the next call goes on from there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
usage="usage: deploy/fuzz.sh MINUTES [TARGET ...]; targets: $(ls tests/fuzz/corpus | tr '\n' ' ')"
[[ ${1:-} =~ ^[0-9]+$ && $1 -gt 0 ]] || { echo "$usage" >&2; exit 2; }
minutes=$1
shift
targets=("$@")
[ $# -gt 0 ] || mapfile -t targets < <(ls tests/fuzz/corpus)
for target in "${targets[@]}"; do
  [ -d "tests/fuzz/corpus/$target" ] || { echo "no target $target; $usage" >&2; exit 2; }
done

if ! command -v clang++ >/dev/null; then
  as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" apt-get install -y -q --no-install-recommends clang
fi
cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target "${targets[@]/#/fuzz_}"

# Files that a target makes are in memory. Leaks of libraries at the end are not ours.
scratch=$(mktemp -d "$([ -w /dev/shm ] && echo /dev/shm || echo /tmp)/amalgam-fuzz-XXXXXX")
trap 'rm -rf "$scratch"' EXIT
export TMPDIR=$scratch
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1:halt_on_error=1}
export ASAN_OPTIONS=${ASAN_OPTIONS:-strict_string_checks=1:detect_leaks=1}
findings=build/fuzz/findings
mkdir -p "$findings"
seconds=$((minutes * 60 / ${#targets[@]}))
status=0
for target in "${targets[@]}"; do
  tried=build/fuzz/tried/$target
  mkdir -p "$tried"
  log=$scratch/$target.log
  # A run over ten seconds or two gigabytes is a finding too.
  if build/fuzz/bin/fuzz_"$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -print_final_stats=1 -artifact_prefix="$findings/$target-" "$tried" "tests/fuzz/corpus/$target" >"$log" 2>&1; then
    result="no finding"
  else
    result="FINDING, see $findings"
    cp "$log" "$findings/$target.log"
    grep -E '^(SUMMARY|==.*ERROR|.*runtime error)|check failed' "$log" | head -5 || true
    status=1
  fi
  printf '%-14s %10s runs in %s s: %s\n' "$target" \
    "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" "$seconds" "$result"
done
exit $status
