#!/usr/bin/env python3
"""Runs the fuzzers of build/fuzz one after another, each for a while, and counts what they did.

Each starts from its seeds (tests/data, tests/fuzz/seeds; files kept as .xz are unpacked) and from
the inputs that it found before, which build/fuzz/corpus keeps. Ends with status 1 if one of them
found something; the input lies in build/fuzz/found then.
"""
import argparse
import csv
import lzma
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "fuzz"
COLUMNS = ["target", "inputs", "seconds", "found"]
LONGEST_SEED = 1 << 14
LONGEST_INPUT = {"triangles": 256, "options": 64, "overlap": 1500, "queries": 800}


def seed_files(target):
    """Files that a target starts from."""
    if target.startswith("read_"):
        extension = target.removeprefix("read_")
        for folder in ("bad", "formats", "nasty"):
            for path in sorted((ROOT / "tests" / "data" / folder).iterdir()):
                if path.is_file() and path.name.endswith((f".{extension}", f".{extension}.xz")):
                    yield path
    else:
        folder = ROOT / "tests" / "fuzz" / "seeds" / target
        yield from sorted(folder.iterdir()) if folder.is_dir() else []


def unpack_seeds(target):
    folder = BUILD / "seeds" / target
    folder.mkdir(parents=True, exist_ok=True)
    for path in seed_files(target):
        content = lzma.open(path).read() if path.suffix == ".xz" else path.read_bytes()
        if len(content) <= LONGEST_SEED:
            (folder / path.name.removesuffix(".xz")).write_bytes(content)
    return folder


def run(target, seconds):
    """Inputs, seconds, and whether something was found."""
    corpus = BUILD / "corpus" / target
    found = BUILD / "found"
    corpus.mkdir(parents=True, exist_ok=True)
    found.mkdir(exist_ok=True)
    command = [BUILD / "tests" / "fuzz" / f"{target}_fuzz", f"-max_total_time={seconds}",
               f"-max_len={LONGEST_INPUT.get(target, LONGEST_SEED)}", "-timeout=60",
               "-rss_limit_mb=2048", "-print_final_stats=1", f"-artifact_prefix={found}/{target}-"]
    words = ROOT / "tests" / "fuzz" / "words" / f"{target}.dict"
    if words.is_file():
        command.append(f"-dict={words}")
    log = BUILD / f"{target}.log"
    with open(log, "w") as out:
        status = subprocess.run([*command, corpus, unpack_seeds(target)], stdout=out,
                                stderr=subprocess.STDOUT).returncode
    text = log.read_text(errors="replace")
    inputs = re.findall(r"stat::number_of_executed_units:\s*(\d+)", text)
    took = re.findall(r"Done \d+ runs in (\d+) second", text)
    if status != 0 or not inputs:
        print(text[-4000:])
        print(f"{target}: found something; the input is in {found}, all words are in {log}")
    return int(inputs[-1]) if inputs else 0, int(took[-1]) if took else 0, int(status != 0)


def read_table(path):
    if not path.is_file():
        return {}
    with open(path, newline="") as file:
        return {row["target"]: [int(row[name]) for name in COLUMNS[1:]]
                for row in csv.DictReader(file)}


def write_table(path, table):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows([target, *table[target]] for target in sorted(table))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=int, default=60, help="of each fuzzer (60)")
    parser.add_argument("--add-to", type=pathlib.Path, metavar="CSV",
                        help="add the counts to those of this file, as tests/fuzz/RESULTS.csv")
    parser.add_argument("targets", nargs="*", help="all, if none is named")
    arguments = parser.parse_args()
    built = sorted(path.name.removesuffix("_fuzz")
                   for path in (BUILD / "tests" / "fuzz").glob("*_fuzz"))
    targets = arguments.targets or built
    if not targets or not set(targets) <= set(built):
        sys.exit(f"{', '.join(arguments.targets) or 'fuzzers'}: not built; built are: "
                 f"{', '.join(built) or 'none'} (make fuzz builds all)")
    table = {}
    for target in targets:
        table[target] = list(run(target, arguments.seconds))
        print("{}: {} inputs in {} s".format(target, *table[target]), flush=True)
    write_table(BUILD / "results.csv", table)
    if arguments.add_to:
        sums = read_table(arguments.add_to)
        for target, counts in table.items():
            sums[target] = [a + b for a, b in zip(counts, sums.get(target, [0, 0, 0]))]
        write_table(arguments.add_to, sums)
    sys.exit(1 if any(found for _, _, found in table.values()) else 0)


if __name__ == "__main__":
    main()
