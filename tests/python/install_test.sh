#!/bin/sh
# install_test.sh PYTHON SOURCE ENVIRONMENT: installs the client as its README says, without a network, into a new
# environment, from a copy of what a clean checkout has of it.
set -eu
python=$1 source=$2 environment=$3

skip() { printf 'Skipped\n%s\n' "$1"; exit 77; }
for module in google.protobuf numpy cv2 setuptools wheel venv; do
  "$python" -c "import $module" 2>/dev/null || skip "no $module for $python"
done
command -v protoc >/dev/null || skip "no protoc"

rm -rf "$environment" "$environment.source"
mkdir -p "$environment.source/client/python/src/amalgam"
cp -r "$source/protocol" "$environment.source/"
cd "$source/client/python"
cp pyproject.toml setup.py README.md "$environment.source/client/python/"
cp src/amalgam/*.py src/amalgam/py.typed "$environment.source/client/python/src/amalgam/"
rm -f "$environment.source/client/python/src/amalgam/amalgam_pb2.py"

"$python" -m venv --system-site-packages "$environment"
"$environment/bin/python" -m pip install -q --no-build-isolation --no-index "$environment.source/client/python"
cd /
"$environment/bin/python" - "$environment" <<'PYTHON'
import pathlib, sys, amalgam
package = pathlib.Path(amalgam.__file__).parent
assert pathlib.Path(sys.argv[1]).resolve() in package.resolve().parents, package
assert (package / "py.typed").exists() and (package / "amalgam_pb2.pyi").exists()
PYTHON

# Without protoc it says what to install.
cd "$environment.source/client/python"
if output=$(PATH=/nowhere "$environment/bin/python" setup.py -q build 2>&1); then
  echo "a build without protoc succeeded" >&2
  exit 1
fi
echo "$output" | grep -q "apt install protobuf-compiler"
