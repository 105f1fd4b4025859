#!/usr/bin/env bash
# Soak: deploy/soak.sh [MINUTES] (default 20). A server, one healthy control client, and beside it random faults and
# random healthy sessions, without a break. Checks that the server is at the end what it was after warming up: as many
# descriptors and threads, and memory that no longer grows: the least that was resident in the last quarter is at most 1 %
# above the quarter before. (The least, because what the allocator holds differs from moment to moment.) Then it is compared with a fresh server: a client alone
# asks the old one and the fresh one in turns, and its 99th percentiles differ by at most 5 %, as far as they can be told
# apart. In turns, because on most machines what the machine itself does differs more from minute to minute. Says the
# control client's percentile under faults too, by quarters: it follows the faults that happen to overlap. Writes soak.csv,
# control.csv, pairs.csv and soak.png to out/soak (SOAK_OUT). SEED repeats the order of faults. SOAK_SERVER_OPTIONS
# replaces the small scene. The last part (SOAK_PAIRS pairs of 2 x 6 s) wants a machine that has nothing else to do.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
minutes=${1:-20}
out=${SOAK_OUT:-out/soak}
bin=${SOAK_BIN:-build/bin}
seed=${SEED:-1}
read -ra scene <<< "${SOAK_SERVER_OPTIONS:---scene deploy/scenes/diffuse.gltf --renderer raytrace}"
rm -rf "$out"
mkdir -p "$out"
RANDOM=$seed

umask 077
echo "soak-$seed-$$" > "$out/token"
children=()
end_children() {
  for child in "${children[@]}"; do kill "$child" 2>/dev/null || true; done
}
trap end_children EXIT
start_server() { # NAME: sets server, address and admin
  "$bin/amalgam-server" "${scene[@]}" --listen 127.0.0.1:0 --admin 127.0.0.1:0 --token-file "$out/token" \
    --log-format json > "$out/$1.txt" 2> "$out/$1.log" &
  server=$!
  children+=("$server")
  for _ in $(seq 300); do
    address=$(sed -n 's/^listening on \([^ ]*\) admin .*/\1/p' "$out/$1.txt")
    admin=$(sed -n 's/^listening on .* admin \([^ ]*\).*/\1/p' "$out/$1.txt")
    [ -z "$address" ] || return 0
    kill -0 "$server" || { echo "soak: the server did not start; see $out/$1.log" >&2; exit 1; }
    sleep 0.1
  done
}
start_server server

load() { "$bin/amalgam-load" --server "$address" --token-file "$out/token" "$@"; }

total=$(awk "BEGIN { print int($minutes * 60) }")
warm_up=$(( total / 10 > 10 ? total / 10 : 10 ))
# Without faults: descriptors of those that have left are closed, and memory is given back (after 3.5 s).
calm=8
rate=30
pairs=${SOAK_PAIRS:-24}
# The control client is there until the last sample: the last faults may take some seconds more.
begin=$SECONDS
load --clients 1 --rate "$rate" --size 160x120 --duration $(( warm_up + total + 2 * calm + 45 )) \
  --latencies "$out/control.csv" > "$out/control.json" &
control=$!
children+=("$control")

sample() { # one line: seconds, resident KiB, descriptors, threads, connections, frames sent
  local rss threads connections frames descriptors
  rss=$(awk '/^VmRSS/ { print $2 }' "/proc/$server/status")
  # Before the admin port is asked, whose connection would count.
  descriptors=$(find "/proc/$server/fd" -mindepth 1 | wc -l)
  threads=$(awk '/^Threads/ { print $2 }' "/proc/$server/status")
  read -r connections frames < <(curl -s -m 2 "http://$admin/metrics" |
    awk '/^amalgam_connections / { c = $2 } /^amalgam_frames_sent_total / { f = $2 } END { print c + 0, f + 0 }')
  echo "$(( SECONDS - begin )),$rss,$descriptors,$threads,$connections,$frames"
}
echo "s,rss_kib,descriptors,threads,connections,frames_sent" > "$out/soak.csv"

faults=(garbage cut half-open hello-only wrong-token slow-reader environments bad-pose bad-image none none)
sizes=(64x48 160x120 320x240)
count=0
declare -A tried=()
one_fault() { # something random for 1 to 4 s, often with another one still going on
  local fault=${faults[RANDOM % ${#faults[@]}]} size=${sizes[RANDOM % ${#sizes[@]}]} seconds=$(( 1 + RANDOM % 4 ))
  # Strangers come from other addresses than the control client, of which wrong tokens are slowed down.
  local -a how=(--faults "$fault" --size "$size" --duration "$seconds" --sources 4 --first-source 2 --rate 10)
  if (( RANDOM % 2 )); then
    how+=(--arrivals $(( 2 + RANDOM % 20 )) --stay 0.5)
  else
    how+=(--clients $(( 1 + RANDOM % 4 )))
  fi
  tried[$fault]=$(( ${tried[$fault]:-0} + 1 ))
  load "${how[@]}" > /dev/null 2>&1 &
  local child=$!
  if (( RANDOM % 4 == 0 )); then # killed in the middle of whatever it is doing
    sleep 0.$(( RANDOM % 10 ))
    kill -9 "$child" 2>/dev/null || true
    tried[killed]=$(( ${tried[killed]:-0} + 1 ))
  elif (( RANDOM % 2 )); then
    ( sleep $(( seconds + 3 )); kill "$child" 2>/dev/null || true ) &
    overlapping+=("$child" "$!")
    return 0
  else
    ( sleep $(( seconds + 3 )); kill "$child" 2>/dev/null || true ) &
    overlapping+=("$!")
  fi
  wait "$child" 2>/dev/null || true
}
overlapping=()
faults_until() {
  while (( SECONDS - begin < $1 )); do
    one_fault
    count=$(( count + 1 ))
    sample >> "$out/soak.csv"
    kill -0 "$server" || { echo "soak: the server has ended; see $out/server.log" >&2; exit 1; }
    kill -0 "$control" || { echo "soak: the control client has ended; see $out/control.json" >&2; exit 1; }
  done
  for child in "${overlapping[@]}"; do wait "$child" 2>/dev/null || true; done
  overlapping=()
}
rest() { # prints a sample of the server with the control client alone
  sleep "$calm"
  sample
}

faults_until "$warm_up"
before=$(rest)
echo "$before" >> "$out/soak.csv"
first_second=$(( SECONDS - begin ))
# The first and the last quarter have the same faults in the same order: what differs is the server's age.
quarter=$(( total / 4 ))
RANDOM=$seed
faults_until $(( first_second + total - quarter ))
RANDOM=$seed
faults_until $(( first_second + total ))
last_second=$(( SECONDS - begin ))
after=$(rest)
echo "$after" >> "$out/soak.csv"
wait "$control" || true

# The old one and a fresh one, in turns; each second pair the other way round.
old=$server old_address=$address
start_server fresh
fresh=$server fresh_address=$address
window() { # ADDRESS: the 99th percentile of six seconds without the first, ms
  address=$1 load --clients 1 --rate 100 --size 160x120 --duration 6 --latencies "$out/window.csv" > /dev/null
  awk -F, 'NR > 1 && $1 >= 1 { print $2 }' "$out/window.csv" | sort -g |
    awk '{ v[NR] = $1 } END { i = int(NR * 0.99 + 0.999); print v[i < 1 ? 1 : i] }'
}
window "$fresh_address" > /dev/null
echo "old_ms,fresh_ms" > "$out/pairs.csv"
for (( i = 0; i < pairs; ++i )); do
  if (( i % 2 )); then of_old=$(window "$old_address"); of_fresh=$(window "$fresh_address")
  else of_fresh=$(window "$fresh_address"); of_old=$(window "$old_address"); fi
  echo "$of_old,$of_fresh" >> "$out/pairs.csv"
done
kill -TERM "$old" "$fresh"
wait "$fresh" || true
wait "$old" && ended=0 || ended=$?

# p99 of a part of the time, in the control client's seconds, which began with ours.
p99() {
  awk -F, -v from="$1" -v to="$2" 'NR > 1 && $1 >= from && $1 < to { print $2 }' "$out/control.csv" | sort -g |
    awk '{ v[NR] = $1 } END { i = int(NR * 0.99 + 0.999); if (NR) printf "%.3f", v[i < 1 ? 1 : i]; else print 0 }'
}

failed=0
check() { # NAME BEFORE AFTER PERCENT: what it may grow by
  local change
  change=$(awk "BEGIN { printf \"%+.2f\", $2 == 0 ? 0 : 100 * ($3 - $2) / $2 }")
  if awk "BEGIN { exit !($change <= $4) }"; then verdict=ok; else verdict=FAILED failed=1; fi
  printf '%-34s %12s %12s %9s %%  (limit %s %%)  %s\n' "$1" "$2" "$3" "$change" "$4" "$verdict"
}
echo "$count faults and sessions in $(( last_second )) s, seed $seed, load of the machine $(cut -d' ' -f1-3 /proc/loadavg):"
for kind in $(printf '%s\n' "${!tried[@]}" | sort); do echo "  $kind: ${tried[$kind]}"; done
printf '%-34s %12s %12s %9s\n' "" "after warm-up" "at the end" change
IFS=, read -r _ _ fds0 threads0 _ <<< "$before"
IFS=, read -r _ _ fds1 threads1 _ <<< "$after"
least() { # of a quarter, KiB
  awk -F, -v from=$(( first_second + $1 * quarter )) -v to=$(( first_second + ($1 + 1) * quarter )) \
    'NR > 1 && $1 >= from && $1 < to && (!n++ || $2 < m) { m = $2 } END { print m + 0 }' "$out/soak.csv"
}
check "descriptors" "$fds0" "$fds1" 0
check "threads" "$threads0" "$threads1" 0
printf '%-34s %12s %12s %9s\n' "" "third quarter" "last quarter" change
check "least resident memory, KiB" "$(least 2)" "$(least 3)" 1
echo "the two quarters before that: $(least 0) and $(least 1) KiB"
# The mean of the pairs' ratios (of their logarithms), and twice its standard error.
read -r ratio error middle_old middle_fresh < <(awk -F, 'NR > 1 { r = log($1 / $2); n++; s += r; q += r * r; a += log($1); b += log($2) }
  END { m = s / n; e = n > 1 ? sqrt((q / n - m * m) / (n - 1)) : 9; printf "%.2f %.2f %.2f %.2f\n", 100 * (exp(m) - 1), 200 * e, exp(a / n), exp(b / n) }' "$out/pairs.csv")
if awk "BEGIN { exit !($ratio - $error > 5) }"; then verdict=FAILED failed=1
elif awk "BEGIN { exit !($ratio + $error > 5) }"; then verdict="not seen to be worse; more SOAK_PAIRS would say more"
else verdict=ok; fi
printf "p99 alone, ms: fresh server %s, old server %s: %+.1f %% +- %.1f %%  (limit 5 %%)  %s\n" \
  "$middle_fresh" "$middle_old" "$ratio" "$error" "$verdict"
printf "control's p99 under faults, ms, by quarters:"
for (( i = 0; i < 4; ++i )); do
  printf ' %s' "$(p99 $(( first_second + i * quarter )) $(( first_second + (i + 1) * quarter )))"
done
printf '\n'
if (( ended != 0 )); then echo "the server ended with $ended"; failed=1; fi

if command -v gnuplot > /dev/null; then
  gnuplot <<PLOT
set terminal pngcairo size 1200,900
set output "$out/soak.png"
set datafile separator ","
set multiplot layout 3,1
set xlabel "s"
set grid
set ylabel "resident, MiB"
plot "$out/soak.csv" every ::1 using 1:(\$2/1024) with lines notitle
set ylabel "count"
plot "$out/soak.csv" every ::1 using 1:3 with lines title "descriptors", "" every ::1 using 1:4 with lines title "threads"
set ylabel "control client, ms"
set logscale y
plot "$out/control.csv" every ::1 using 1:2 with dots title "latency, from when the frame was due"
PLOT
fi
exit "$failed"
