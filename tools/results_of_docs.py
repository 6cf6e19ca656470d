#!/usr/bin/env python3
"""Takes the verdicts of docs/reproduce.md from a run: writes them to the table "Results", and to
tests/data/thesis/results_of_docs.csv, which a test holds the table to.

usage: tools/results_of_docs.py RUN_JSON           write both
       tools/results_of_docs.py RUN_JSON --check   end with 1 if they are not what would be written

RUN_JSON is run.json of `soms reproduce --quick --item claims --models DIR` with all models, on an
idle machine. What decides stands in the last column and is written by hand.
"""
import csv
import io
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/reproduce.md"
RECORD = ROOT / "tests/data/thesis/results_of_docs.csv"
COLUMNS = ["id", "claim", "scope", "timed", "nearest", "nearest_hold", "nearest_undecided",
           "nearest_fail", "subjects", "counted", "measured", "verdict", "hold", "judged"]


def record_of(claims):
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(COLUMNS)
    for claim in claims:
        nearest = claim["nearest"]
        table.writerow([claim["id"], claim["claim"], claim["scope"], "yes" if claim["timed"] else "",
                        nearest["verdict"], nearest["hold"], nearest["undecided"], nearest["fail"],
                        nearest["subjects"], nearest["counted"]["verdict"],
                        nearest["measured"]["verdict"], claim["verdict"], claim["hold"], claim["judged"]])
    return text.getvalue()


def cell(words, hold, judged):
    return words if judged == 0 else f"{words}, {hold} of {judged}"


def page_with(claims, page):
    for claim in claims:
        start = f"| {claim['claim']} | "
        lines = [line for line in page.splitlines() if line.startswith(start)]
        if len(lines) != 1:
            sys.exit(f"docs/reproduce.md has {len(lines)} rows of the claim: {claim['claim']}")
        reason = lines[0].removesuffix(" |").rsplit(" | ", 1)[1]
        nearest = claim["nearest"]
        page = page.replace(lines[0], start + " | ".join([
            cell(nearest["verdict"], nearest["hold"], nearest["rows"]),
            cell(claim["verdict"], claim["hold"], claim["judged"]), reason]) + " |")
    return page


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    run = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    claims = [claim for item in run["items"] for claim in item["claims"]]
    page = PAGE.read_text(encoding="utf-8")
    wanted = {RECORD: record_of(claims), PAGE: page_with(claims, page)}
    if sys.argv[2:]:
        sys.exit(any(not file.is_file() or file.read_text(encoding="utf-8") != text
                     for file, text in wanted.items()))
    for file, text in wanted.items():
        file.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
