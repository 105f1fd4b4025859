#!/bin/sh
# Each alert is raised by what it is for, and by nothing else. Exits with 77 where promtool is missing.
set -eu
cd "${1:?usage: alert_rules_test.sh FOLDER}"
if ! command -v promtool >/dev/null; then
  printf 'Skipped\npromtool is not installed\n'
  exit 77
fi
promtool check rules amalgam.rules.yml
promtool test rules amalgam.rules.test.yml
# An alert without a test would be believed.
for alert in $(sed -n 's/^ *- alert: //p' amalgam.rules.yml); do
  grep -q "alertname: $alert$" amalgam.rules.test.yml || { echo "no test raises $alert"; exit 1; }
done
