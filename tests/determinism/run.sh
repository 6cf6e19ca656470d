#!/bin/sh
# Builds the library by each compiler, with each optimization and for each instruction set, and
# compares what it makes and answers with tests/golden/answers.csv.
# usage: run.sh BUILD_FOLDER [JOBS]
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/../.." && pwd)
build=$1
jobs=${2:-1}

one() {
  compiler=$1
  name=$2
  shift 2
  folder="$build/$compiler-$name"
  echo "$compiler $*"
  cmake -G Ninja -S "$root/tests/determinism" -B "$folder" --log-level=WARNING \
    -D CMAKE_CXX_COMPILER="$compiler" -D CMAKE_CXX_FLAGS="$*"
  cmake --build "$folder" -j "$jobs" --target golden -- --quiet
  ctest --test-dir "$folder" -j "$jobs" --output-on-failure --no-tests=error
}

# Whole programs for newer processors: what their compilers fuse and widen must not show.
offers() { grep -q -m1 -w "$1" /proc/cpuinfo; }

for compiler in g++ clang++; do
  one "$compiler" O0 -O0
  one "$compiler" O1 -O1
  one "$compiler" O3 -O3
  if offers avx2; then
    one "$compiler" avx2 -O3 -march=haswell
  else
    echo "skipped: $compiler for AVX2, which this processor does not have"
  fi
  if offers avx512vl; then
    one "$compiler" avx512 -O3 -march=skylake-avx512
  else
    echo "skipped: $compiler for AVX-512, which this processor does not have"
  fi
done
