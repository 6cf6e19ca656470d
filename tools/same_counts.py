#!/usr/bin/env python3
"""Compares two runs of `soms reproduce` but for times: every cell of every table that run.json does
not call timed, and every figure that it does not.

usage: tools/same_counts.py DIR DIR

Prints how much was compared and ends with 1 if anything differs.
"""
import csv
import json
import pathlib
import sys


def files_of(folder):
    run = json.loads((folder / "run.json").read_text(encoding="utf-8"))
    return {entry["file"]: entry for item in run["items"] for entry in item["files"]}


def masked(path, timed):
    with path.open(encoding="utf-8", newline="") as file:
        return [["" if i in timed else cell for i, cell in enumerate(row)]
                for row in csv.reader(file)]


def difference(one, other):
    """The first row that differs, or nothing."""
    if len(one) != len(other):
        return f"{len(one)} and {len(other)} rows"
    return next((f"row {k}: {a} and {b}" for k, (a, b) in enumerate(zip(one, other)) if a != b), "")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    one, other = (pathlib.Path(word) for word in sys.argv[1:])
    files, others = files_of(one), files_of(other)
    faults = [f"{name}: in one run alone" for name in sorted(files.keys() ^ others.keys())]
    cells = compared = 0
    for name, entry in sorted(files.items()):
        if name not in others or entry.get("timed"):
            continue
        compared += 1
        if "timed_columns" in entry:
            tables = [masked(folder / name, entry["timed_columns"]) for folder in (one, other)]
            cells += sum(len(row) - len(entry["timed_columns"]) for row in tables[0])
            found = difference(*tables)
        else:
            found = "" if (one / name).read_bytes() == (other / name).read_bytes() else "other bytes"
        if found:
            faults.append(f"{name}: {found}")
    print(f"{compared} files, {cells:,} cells that are no times: {len(faults)} differ")
    sys.exit("\n".join(faults) if faults else 0)


if __name__ == "__main__":
    main()
