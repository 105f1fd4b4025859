#!/bin/sh
# The service's exposure, as systemd judges it, is at most 1.5 of 10. Exits with 77 where systemd is missing.
set -eu
unit=${1:?usage: unit_exposure_test.sh UNIT}
if ! command -v systemd-analyze >/dev/null; then
  printf 'Skipped\nsystemd-analyze is not installed\n'
  exit 77
fi
# The threshold is ten times the exposure. No pipe: its status would hide that of the judge.
systemd-analyze security --offline=true --no-pager --threshold=15 "$unit"
# LLVM, which llvmpipe compiles shaders with, writes code and runs it.
if grep -q '^MemoryDenyWriteExecute=' "$unit"; then
  echo 'llvmpipe does not work with MemoryDenyWriteExecute'
  exit 1
fi
grep -q '^Type=notify$' "$unit"
grep -q '^WatchdogSec=' "$unit"
# A bare Debian has nothing but the package's programs and the shell. /bin/kill is not there, which a reload once ran.
if grep -E '^Exec[A-Za-z]+=' "$unit" | grep -vE '=(/usr/bin/amalgam-server|/bin/sh) '; then
  echo 'that program may be missing'
  exit 1
fi
