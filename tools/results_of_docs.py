#!/usr/bin/env python3
"""Prints the verdicts of a run as CSV: what docs/reproduce.md says of every claim is held to them.

usage: tools/results_of_docs.py RUN_JSON > tests/data/thesis/results_of_docs.csv

RUN_JSON is run.json of `soms reproduce --quick --item claims --models DIR` with all models.
"""
import csv
import json
import sys

COLUMNS = ["id", "claim", "scope", "timed", "nearest", "nearest_hold", "nearest_undecided",
           "nearest_fail", "subjects", "verdict", "hold", "judged"]


def row_of(claim):
    nearest = claim["nearest"]
    return [claim["id"], claim["claim"], claim["scope"], "yes" if claim["timed"] else "",
            nearest["verdict"], nearest["hold"], nearest["undecided"], nearest["fail"],
            nearest["subjects"], claim["verdict"], claim["hold"], claim["judged"]]


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        run = json.load(file)
    table = csv.writer(sys.stdout, lineterminator="\n")
    table.writerow(COLUMNS)
    for item in run["items"]:
        table.writerows(row_of(claim) for claim in item["claims"])


if __name__ == "__main__":
    main()
