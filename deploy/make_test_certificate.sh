#!/bin/sh
# Makes a certificate for this machine's loopback addresses, for trying TLS out: DIR/server.crt and DIR/server.key.
# It signs itself, so clients trust it by --ca DIR/server.crt.
set -eu
folder=${1:?usage: make_test_certificate.sh DIR [HOST]}
host=${2:-localhost}
mkdir -p "$folder"
umask 077
openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 30 \
  -subj "/CN=$host" -addext "subjectAltName=DNS:$host,IP:127.0.0.1,IP:::1" \
  -keyout "$folder/server.key" -out "$folder/server.crt" 2>/dev/null
chmod 644 "$folder/server.crt"
