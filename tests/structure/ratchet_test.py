"""The house may not fill up further: files of a folder, lines of a room, and headers of one name only fall.

A limit holds for everything, and ratchet.csv lists what was over it when it was recorded, with its number then:

  files    sources directly in a folder; limit 45. A listed folder may not grow at all.
  lines    lines of sources in a room, its folders included; limit 10,000. A listed room may grow by 2 % of what is
           recorded, so that work on it goes on. A room is a folder of soms/ or apps/, or else a top folder. tests/ is
           no room here, since every fault gets its test.
  headers  headers of one base name in one namespace; limit 1. A listed name may not get another header.

So a new folder, room or name needs no row. Sources are .h, .cpp, .js, .mjs, .ts and .py; data, bundles and builds do
not count. The test also says which rows can be lowered. With --record it lowers them, and removes those at the limit.
It never raises a number: split the folder instead, or change the row by hand, with the reason in the commit.

usage: ratchet_test.py ROOT [--record]
"""
import collections
import csv
import pathlib
import re
import sys

LIMITS = {"files": 45, "lines": 10_000, "headers": 1}
GROWTH = {"lines": 0.02}  # of the recorded number; nothing else may grow
SUFFIXES = {".h", ".cpp", ".js", ".mjs", ".ts", ".py"}
SKIPPED = {"build", "node_modules", "__pycache__", "tests/data", "apps/report/web/dist"}
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{", re.MULTILINE)
LEAST_SOURCES = 600
RECORD = pathlib.Path(__file__).with_name("ratchet.csv")


def sources(folder, inside=""):
    """(folder from the root, path) of every source."""
    for path in sorted(folder.iterdir()):
        name = f"{inside}/{path.name}" if inside else path.name
        if path.is_dir() and not path.is_symlink():
            is_build = path.name.startswith(".") or (path / "CMakeCache.txt").exists()
            if not is_build and name not in SKIPPED and path.name not in SKIPPED:
                yield from sources(path, name)
        elif path.suffix in SUFFIXES:
            yield inside or ".", path


def room_of(folder):
    parts = folder.split("/")
    return "/".join(parts[:2]) if parts[0] in {"soms", "apps"} else parts[0]


def numbers(root):
    """{(kind, name): number} of all folders, rooms and headers."""
    now = collections.Counter()
    for folder, path in sources(root):
        now["files", folder] += 1
        text = path.read_text(encoding="utf-8")
        if room_of(folder) != "tests":
            now["lines", room_of(folder)] += len(text.splitlines())
        if path.suffix == ".h":
            for namespace in set(NAMESPACE.findall(text)) or {"none"}:
                now["headers", f"{namespace} {path.name}"] += 1
    return now


def recorded():
    with open(RECORD, encoding="utf-8", newline="") as file:
        return {(row["kind"], row["name"]): int(row["number"]) for row in csv.DictReader(file)}


def write(rows):
    with open(RECORD, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["kind", "name", "number"])
        writer.writerows([*key, number] for key, number in sorted(rows.items()))


def most(key, rows):
    limit, was = LIMITS[key[0]], rows.get(key, 0)
    return max(limit, was + int(was * GROWTH.get(key[0], 0)))


def main():
    now = numbers(pathlib.Path(sys.argv[1]))
    if sum(n for (kind, _), n in now.items() if kind == "files") < LEAST_SOURCES:
        sys.exit("too few sources were found: is this the root of the repository?")
    rows = recorded() if RECORD.exists() else {key: n for key, n in now.items() if n > LIMITS[key[0]]}
    lower = {key: max(now[key], LIMITS[key[0]]) for key in rows if now[key] < rows[key]}
    if "--record" in sys.argv:
        rows.update(lower)
        write({key: n for key, n in rows.items() if n > LIMITS[key[0]]})
    else:
        for (kind, name), number in sorted(lower.items()):
            print(f"can be lowered by --record: {kind} of {name} from {rows[kind, name]} to {number}")
    found = [key for key in sorted(now) if now[key] > most(key, rows)]
    for kind, name in found:
        print(f"{kind} of {name}: {now[kind, name]}, at most {most((kind, name), rows)}")
    print(f"{len(now)} numbers, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
