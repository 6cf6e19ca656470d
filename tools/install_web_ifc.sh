#!/bin/sh
# Installs the npm package web-ifc, which reads IFC, into a build folder for the tests: install_web_ifc.sh BUILD.
# Without npm, or where its registry is out of reach, it says so, and the tests that need it skip.
set -eu
version=0.0.78
[ $# -eq 1 ] || { echo "usage: install_web_ifc.sh BUILD" >&2; exit 2; }
folder=$1/npm

if grep -qs "\"version\": \"$version\"" "$folder/node_modules/web-ifc/package.json"; then
  exit 0
fi
if ! command -v npm >/dev/null 2>&1 || ! command -v node >/dev/null 2>&1; then
  echo "SKIPPED: the tests of IFC by web-ifc, as node and npm are not on PATH" >&2
  exit 0
fi
mkdir -p "$folder"
# A failed update must not leave another version to be tested.
rm -rf "$folder/node_modules/web-ifc"
if ! npm install --prefix "$folder" --no-save --no-audit --no-fund --ignore-scripts --fetch-retries=1 "web-ifc@$version"; then
  rm -rf "$folder/node_modules/web-ifc"
  echo "SKIPPED: the tests of IFC by web-ifc, as npm could not install it" >&2
fi
