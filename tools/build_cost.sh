#!/bin/bash
# What builds cost, in seconds of processor time (user and system of all compilers), without ccache:
#   tools/build_cost.sh                 the build of `make run`, from nothing
#   tools/build_cost.sh FILE...         after it, for a contributor (preset work): until the command runs again
#                                       after a change of each file
# Builds go to build/cost and build/cost-work. JOBS=1 gives the steadiest figures.
set -euo pipefail
cd "$(dirname "$0")/.."
jobs=${JOBS:-$(nproc)}
export CCACHE_DISABLE=1
TIMEFORMAT='%U %S %R'

# timed NAME COMMAND...: runs it quietly and says what it took.
timed() {
  local name=$1 took
  shift
  took=$({ time "$@" >build/cost.log 2>&1; } 2>&1) || { cat build/cost.log; exit 1; }
  echo "$took" | awk -v name="$name" '{ printf "%-44s %7.1f s of processor time, %6.1f s\n", name, $1 + $2, $3 }'
}

mkdir -p build
if [ $# -eq 0 ]; then
  rm -rf build/cost
  timed "make run: configure" cmake --preset release -B build/cost -D SOMS_BUILD_TESTS=OFF -D SOMS_BUILD_THESIS=OFF
  timed "make run: compile and link" cmake --build build/cost -j "$jobs" --target soms_command
  exit
fi
timed "preset work, or what of it is not built yet" sh -c \
  "cmake --preset work -B build/cost-work -D SOMS_BUILD_TESTS=OFF && cmake --build build/cost-work -j $jobs --target soms_command"
for file in "$@"; do
  touch "$file"
  timed "$file" sh -c "cmake --build build/cost-work -j $jobs --target soms_command && build/cost-work/bin/soms --version"
done
