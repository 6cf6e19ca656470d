#!/bin/sh
# Installs the Debian packages that the named sections of packages.txt list and that are missing, also as a program in PATH.
# Elsewhere than on Debian it names what is needed and goes on: the build says what it misses.
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
[ $# -gt 0 ] || { echo "usage: install_packages.sh SECTION..." >&2; exit 2; }

wanted=
for section in "$@"; do
  # A row is "PACKAGE" or "PACKAGE or PROGRAM".
  rows=$(awk -v s="[$section]" '/^\[/ { on = ($0 == s); next } on && NF && !/^#/ { print $1 ":" ($2 == "or" ? $3 : "") }' \
    "$root/packages.txt")
  for row in $rows; do
    program=${row#*:}
    if [ -z "$program" ] || ! command -v "$program" >/dev/null 2>&1; then
      wanted="$wanted ${row%%:*}"
    fi
  done
done

if ! command -v dpkg-query >/dev/null 2>&1 || ! command -v apt-get >/dev/null 2>&1; then
  echo "This system has no apt. Needed, by their Debian names:"
  # shellcheck disable=SC2086
  printf '  %s\n' $wanted
  exit 0
fi

missing=
for package in $wanted; do
  state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
  if command -v sudo >/dev/null 2>&1; then
    as_root=sudo
  else
    echo "Missing packages, and neither root nor sudo to install them:$missing" >&2
    exit 1
  fi
fi
echo "Installing:$missing"
export DEBIAN_FRONTEND=noninteractive
# shellcheck disable=SC2086
install_all() { $as_root apt-get install -y -q --no-install-recommends $missing; }
# Package lists may be absent or old on a fresh system; they are fetched only where needed.
install_all || { echo "apt did not find all of them: fetching its lists" && $as_root apt-get update -q && install_all; }
