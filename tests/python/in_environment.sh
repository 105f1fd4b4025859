#!/bin/sh
# in_environment.sh ENVIRONMENT NEEDED MODULE ARGUMENT...: runs a module in the environment of install_test.sh. Skipped
# without that, or without the module NEEDED. mypy is asked of Debian's Python about the environment's packages.
environment=$1 needed=$2
shift 2
python=$environment/bin/python
[ -x "$python" ] || { printf 'Skipped\nthe Python client is not installed\n'; exit 77; }
"$python" -c "import $needed" 2>/dev/null || { printf 'Skipped\nno %s for Python\n' "$needed"; exit 77; }
exec "$python" -m "$@"
