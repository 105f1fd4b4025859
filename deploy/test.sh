#!/usr/bin/env bash
# Installs what is missing, builds with warnings as errors, runs all tests, checks the formatting and, with clang-tidy,
# what the last commit changed. From nothing about 25 minutes on two cores, later about 12. The bunnies are tested if they
# can be fetched; what is skipped is listed at the end.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# step NAME COMMAND...: runs it and says how long it took.
step() {
  local name=$1 start=$SECONDS
  shift
  echo "== $name"
  "$@"
  echo "== $name: $((SECONDS - start)) s"
}

run_tests() {
  ctest --test-dir build --output-on-failure --no-tests=error --output-junit test_results.xml -j "$(nproc)"
}

check_format() {
  git ls-files '*.cpp' '*.h' | xargs clang-format --dry-run -Werror
  echo "all files are formatted"
}

# One line a reason, with the number of tests.
list_skipped() {
  python3 - build/test_results.xml <<'PYTHON'
import collections, re, sys, xml.etree.ElementTree as tree
reasons = collections.Counter()
for case in tree.parse(sys.argv[1]).getroot().iter("testcase"):
    if case.find("skipped") is not None or case.get("status") in ("notrun", "disabled"):
        said = re.search(r"Skipped\n(.+)", case.findtext("system-out") or "")
        reasons[said.group(1).strip() if said else "no reason given"] += 1
print("skipped: none" if not reasons else "\n".join(f"skipped: {n} tests: {why}" for why, n in reasons.items()))
PYTHON
}

step install deploy/install.sh
step build deploy/build.sh
step assets deploy/fetch_assets.sh bunny
step tests run_tests
list_skipped
step formatting check_format
step clang-tidy deploy/tidy.sh
