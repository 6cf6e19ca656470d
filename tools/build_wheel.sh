#!/bin/sh
# Builds the wheel of the Python package into the folder OUT, without the network, and says how to install
# it. PYTHON chooses the interpreter; by default the first one that has what is needed: Debian's may
# not be the first in the path.
set -eu
[ $# -eq 1 ] || { echo "usage: build_wheel.sh OUT" >&2; exit 2; }
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
python=${PYTHON:-}
for candidate in python3 /usr/bin/python3; do
  [ -z "$python" ] || break
  "$candidate" -c 'import setuptools, wheel, pip, numpy' 2>/dev/null && python=$candidate
done
[ -n "$python" ] || { echo "no python3 has numpy, pip, setuptools and wheel" >&2; exit 1; }

mkdir -p "$1"
rm -f "$1"/soms-*.whl
(cd "$root" && "$python" -m pip wheel . --no-build-isolation --no-deps --quiet --wheel-dir "$1")
wheel=$(ls "$1"/soms-*.whl)
echo "$wheel ($("$python" -V))"
echo "install it:  python3 -m venv --system-site-packages ~/soms-env && ~/soms-env/bin/python -m pip install --no-deps $wheel"
