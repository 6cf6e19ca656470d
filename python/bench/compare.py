"""What a call from Python costs beside the same one in C++, in one run, turn by turn.

    compare.py TWIN [POSES [CALLS [TURNS]]]

TWIN is built by `cmake --build build/release --target soms_python_twin`. Medians of the processor
time of all turns. Pin it to a core (`taskset -c 0`).
"""
import statistics
import subprocess
import sys
import time

import numpy as np

import soms


def places(count):
    """As of twin.cpp, bit by bit."""
    i = np.arange(count)
    poses = np.tile([[0.6, -0.8, 0, 0], [0.8, 0.6, 0, 0], [0, 0, 1, 0.25]], (count, 1, 1))
    poses[:, 0, 3] = (i % 1000) * 2.0 - 1000
    poses[:, 1, 3] = (i // 1000 % 1000) * 2.0 - 1000
    return poses


def ours(city, car, poses, calls):
    begin = time.process_time()
    batch = soms.overlap(car, city, poses, mode="any")
    together = time.process_time() - begin
    far = soms.Body(car, [0, 0, 5000])
    begin = time.process_time()
    for _ in range(calls):
        soms.overlap(far, city, mode="any")
    return together, (time.process_time() - begin) / calls, np.count_nonzero(batch.any)


def main():
    twin, numbers = sys.argv[1], [int(word) for word in sys.argv[2:]]
    count, calls, turns = (*numbers, *(1_000_000, 200_000, 5)[len(numbers):])
    city = soms.Body(soms.generate("city", size=4000, streets="bare"))
    car = soms.Shape(soms.generate("car"))
    poses = places(count)
    rows = []
    for _ in range(turns):
        said = subprocess.run([twin, str(count), str(calls)], check=True, capture_output=True,
                              text=True).stdout.split()
        here = ours(city, car, poses, calls)
        if here[2] != int(said[2]):
            sys.exit(f"{here[2]} poses touch, in C++ {said[2]}")
        rows.append((*map(float, said[:2]), *here[:2]))
    cpp_batch, cpp_call, batch, call = map(statistics.median, zip(*rows))
    print(f"{count} poses in one call: C++ {cpp_batch:.3f} s, Python {batch:.3f} s, "
          f"ratio {batch / cpp_batch:.3f}")
    print(f"a call: C++ {cpp_call * 1e6:.3f} us, Python {call * 1e6:.3f} us, "
          f"{(call - cpp_call) * 1e6:.3f} us over it")


if __name__ == "__main__":
    main()
