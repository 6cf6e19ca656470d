#!/usr/bin/env python3
"""Counts what docs/trust.md speaks of, from the files that the tests read, and writes its tables.

usage: tools/trust_numbers.py           rewrite the tables
       tools/trust_numbers.py --check   end with 1 if they are not what would be written
"""
import collections
import csv
import lzma
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
DATA = ROOT / "tests/data"
PAGE = ROOT / "docs/trust.md"
EXTENSIONS = {"glb": "gltf"}


def rows(path):
    opened = lzma.open(path, "rt", encoding="utf-8") if path.suffix == ".xz" else open(
        path, newline="", encoding="utf-8")
    with opened as file:
        return list(csv.DictReader(file))


def by_extension(files):
    """Numbers of files by their extension, the greatest first: "ply 99, stl 21, ..."."""
    counts = collections.Counter()
    for file in files:
        extension = pathlib.PurePath(file.removesuffix(".xz")).suffix[1:].lower()
        counts[EXTENSIONS.get(extension, extension) or "none"] += 1
    many = {name: n for name, n in counts.items() if n > 2}
    rest = sum(counts.values()) - sum(many.values())
    reported = [f"{name} {n}" for name, n in sorted(many.items(), key=lambda item: (-item[1], item[0]))]
    return ", ".join(reported + ([f"others {rest}"] if rest else []))


def truth():
    own = {mesh["mesh"] for mesh in rows(DATA / "truth/meshes.csv")
           if mesh["file"].startswith("meshes/")}
    cases = rows(DATA / "truth/cases.csv.xz")
    touching = sum(case["overlap"] == "1" for case in cases)
    inside = sum(case["solid"] in {"a_in_b", "b_in_a", "both"} for case in cases)
    here = sum(case["meshA"] in own and case["meshB"] in own for case in cases)
    yield ("truth cases: posed pairs of meshes", len(cases),
           f"{touching:,} overlap, {inside} contain without touching; {here:,} use meshes of this "
           "repository, the others need `SOMS_DATA`")
    total = next(row for row in rows(DATA / "truth/stats.csv") if row["kind"] == "all")
    yield ("triangle pairs in them, decided by two exact methods", int(total["box_pairs"]),
           f"{int(total['overlaps']):,} overlap")
    single = collections.Counter(row["kind"] for row in rows(DATA / "truth/tritri.csv.xz"))
    kinds = ", ".join(f"{kind} {n:,}" for kind, n in sorted(single.items()))
    yield "single pairs of triangles", sum(single.values()), kinds


def distances():
    for file, what, all_rows in (("tridist", "distances of single pairs of triangles", 8200),
                                 ("cases", "distances of posed pairs of meshes", 1010),
                                 ("closest", "distances of a point and a mesh", 10164)):
        here = rows(DATA / f"distance/{file}.csv.xz")
        zero = sum(float(row["hi"]) == 0 for row in here)
        yield what, all_rows, (f"{len(here)} in this repository, the others need `SOMS_DATA`; of the "
                               f"{len(here)}, {zero} are 0")


def questions():
    here = rows(DATA / "questions/inside.csv.xz")
    sides = collections.Counter(row["answer"] for row in here)
    yield ("points beside closed meshes, their sides decided by two exact methods", 20000,
           f"{len(here):,} in this repository, the others need `SOMS_DATA`; of these, "
           + ", ".join(f"{side} {n:,}" for side, n in sorted(sides.items())))
    here = rows(DATA / "questions/ray.csv.xz")
    hit = sum(row["any"] == "1" for row in here)
    ties = sum(int(row["ties"]) > 1 for row in here)
    yield ("rays and what they hit, decided by two exact methods", 13400,
           f"{len(here):,} in this repository, the others need `SOMS_DATA`; of these, {hit:,} hit "
           f"something, {ties:,} of them several triangles at once")
    here = rows(DATA / "questions/closed.csv.xz")
    yield ("meshes and connected parts whose odd edges were counted by two methods", 511,
           f"{len(here)} in this repository, the others need `SOMS_DATA`")


def files():
    bad = rows(DATA / "bad/EXPECTED.csv")
    said = collections.Counter("error" if row["expectation"] == "error" else "mesh" if
                               row["expectation"].startswith("mesh") else "either" for row in bad)
    yield ("broken or hostile files", len(bad),
           f"{said['error']} must be an error, {said['mesh']} a mesh of a stated size, "
           f"{said['either']} either; {by_extension(row['file'] for row in bad)}")
    losses = {row["file"]: row["outcome"] for row in rows(DATA / "losses/EXPECTED.csv")}
    refused = sum(outcome == "error" for outcome in losses.values())
    yield ("files that hold more than is read of them", len(losses),
           f"{refused} must be an error, {len(losses) - refused} a mesh with notes; "
           f"{by_extension(losses)}")
    formats = rows(DATA / "formats/FORMATS.csv")
    yield ("encodings of one mesh", len(formats), by_extension(row["file"] for row in formats))
    nasty = rows(DATA / "nasty/EXPECTED.csv")
    yield ("valid files of hard geometry", len(nasty), by_extension(row["file"] for row in nasty))


def thesis():
    for name, what in (("counts", "trees of the thesis"), ("traversal", "traversals of the thesis")):
        table = rows(DATA / f"thesis/thesis_{name}.csv")
        yield f"rows of counts: {what}", len(table), f"{len(table[0])} columns each"
    more = {name: len(rows(DATA / f"thesis/{name}.csv")) for name in
            ("other_objects", "corner_pair", "e_node_readings", "e_node_levels", "first_frames")}
    yield ("rows of counts: other objects and readings of the thesis", sum(more.values()),
           ", ".join(f"{name} {number}" for name, number in more.items()))


def golden():
    kept = collections.Counter(row["what"].split()[0] for row in
                               rows(ROOT / "tests/golden/answers.csv"))
    yield ("hashes that every build must give", sum(kept.values()),
           f"{kept['tree']} of trees, {kept['read'] + kept['write']} of files read and written, "
           "the others of answers, scenes and generated models")


def regressions():
    """Rows of docs/regressions.md, "| id | fault | reported in | state | tests |", by state."""
    text = (ROOT / "docs/regressions.md").read_text(encoding="utf-8")
    states, tests = collections.Counter(), set()
    for line in text.splitlines():
        if re.match(r"\| R\d+ \|", line):
            _, _, _, state, named = line.removeprefix("| ").removesuffix("|").split(" | ")
            states[re.split("[;:]", state)[0]] += 1
            tests.update(re.findall("`(.+?)`", named))
    reported = ", ".join(f"{number} {state}" for state, number in states.most_common())
    yield "faults of other libraries", sum(states.values()), f"{reported}; {len(tests)} tests by name"


def counted():
    yield "| what | how many | of these |"
    yield "|---|---:|---|"
    for part in (truth, distances, questions, files, regressions, thesis, golden):
        for what, number, note in part():
            yield f"| {what} | {number:,} | {note} |"


def fuzzed():
    yield "| fuzzer | inputs | minutes | found |"
    yield "|---|---:|---:|---:|"
    runs = rows(ROOT / "tests/fuzz/RESULTS.csv")
    for run in runs:
        yield (f"| `{run['target']}` | {int(run['inputs']):,} | {int(run['seconds']) / 60:,.0f} | "
               f"{run['found']} |")
    inputs, seconds, found = (sum(int(run[k]) for run in runs) for k in ("inputs", "seconds", "found"))
    yield f"| all | {inputs:,} | {seconds / 60:,.0f} | {found} |"


TABLES = {"counted": counted, "fuzzed": fuzzed}


def written(text):
    for name, table in TABLES.items():
        marks = f"<!-- {name}: written by tools/trust_numbers.py -->\n", f"<!-- end of {name} -->"
        before, rest = text.split(marks[0])
        after = rest.split(marks[1], 1)[1]
        text = before + marks[0] + "\n" + "\n".join(table()) + "\n\n" + marks[1] + after
    return text


def missing_in_readme():
    """Totals that README's paragraph should name and does not."""
    section = (ROOT / "README.md").read_text(encoding="utf-8").split("## How far to trust it")[1]
    named = ("truth cases", "single pairs", "broken")
    return [what for part in (truth, files) for what, number, _ in part()
            if what.startswith(named) and f"{number:,}" not in section.split("\n## ")[0]]


def main():
    text = PAGE.read_text(encoding="utf-8")
    new = written(text)
    if sys.argv[1:] == ["--check"]:
        if new != text:
            print("docs/trust.md does not hold today's numbers: run tools/trust_numbers.py")
            return 1
        if missing_in_readme():
            print("README.md has another number of:", *missing_in_readme(), sep="\n  ")
            return 1
    else:
        PAGE.write_text(new, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
