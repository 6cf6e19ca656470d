"""The comparison of what pages show with what commands print finds what differs, and only that."""
import sys

from printed import difference

ALIKE = [
    ("a 12 b\n  c", "a 12 b c\n"),
    ("count 5, in 3 ms", "count 5, in 99.5 ms"),
    ('{"build_ms":1.5,\n "n":2}', '{"build_ms":77,"n":2}'),
    ("knot ... 2000 triangles", "knot of reach 1, 2000 triangles"),
    ("...", ""),
    ("-0.81 and 1.0", "-0.8139 and 0.99933"),
    ("rule  SAH  build ms\nsoms  30.80  1.5\nfast  29.86  2", "rule SAH build ms\nsoms 30.80 9\nfast 29.86 3.25"),
    ("|sum|us (least)|\n|--:|---|\n|4|1.5 (1)|\n...\n|5|2 (1)|",
     "|sum|us (least)|\n|--:|---|\n|4|9.5 (8)|\n|7|1 (1)|\n|5|3 (2)|"),
]
DIFFERENT = [
    ("a 12 b", "a 13 b"),
    ("a 12", "a 12 b"),
    ("a 12 b", "a 12"),
    ("count 5, in 3 ms", "count 6, in 3 ms"),
    ("in 3 ms", "in three ms"),
    ("3 triangles", "3.1 triangles"),
    ("-0.81", "-0.82"),
    ("0.81", "-0.81"),
    ('{"build_ms":1.5}', '{"build_us":1.5}'),
    ("knot ... 2000 triangles", "knot of 2001 triangles"),
    ("rule  SAH  build ms\nsoms  30.80  1.5", "rule SAH build ms\nsoms 30.81 1.5"),
    ("|sum|us|\n|--:|---|\n|4|1.5|", "|sum|us|\n|--:|---|\n|5|1.5|"),
    ("build ms\nsoms 1.5\nnone\nsoms 2.5", "build ms\nsoms 1.6\nnone\nsoms 2.6"),
]


def main():
    faults = [f"taken for different: {pair}" for pair in ALIKE if difference(*pair)]
    faults += [f"taken for alike: {pair}" for pair in DIFFERENT if not difference(*pair)]
    print(*faults, sep="\n")
    print(f"{len(ALIKE) + len(DIFFERENT)} pairs, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
