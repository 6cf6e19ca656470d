"""The clash list of a city: which parts of two models touch, as a table.

    city_clashes.py [TRIANGLES]

A tube runs through the city. Each pair of triangles is counted for the parts that they belong to.
"""
import collections
import sys

import soms


def main():
    triangles = int(sys.argv[1]) if len(sys.argv) > 1 else 200_000
    city = soms.generate("city", triangles, size=1000)
    tube = soms.generate("knot", 20_000).transformed(150)
    answer = soms.overlap(soms.Body(tube, [0, 0, 20]), city, threads=0)
    parts = city.parts
    clashes = collections.Counter(city.part_of(answer.pairs[:, 1]).tolist())
    print(f"{len(answer.pairs)} pairs of triangles, {len(clashes)} parts of the city")
    print(f"{'part':>6}  {'pairs':>6}  name")
    for part, pairs in sorted(clashes.items(), key=lambda row: (-row[1], row[0]))[:10]:
        print(f"{part:>6}  {pairs:>6}  {parts[part].name if part >= 0 else ''}")


if __name__ == "__main__":
    main()
