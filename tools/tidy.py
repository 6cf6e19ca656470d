#!/usr/bin/env python3
"""Runs clang-tidy on the sources of the library, the programs and the thesis, several at once: `make tidy SINCE=COMMIT`.

With SINCE only on those that changed since that commit, and for each header that did on a source that includes it.
Needs `cmake --preset tidy`; nothing is built. Ends with status 1 if clang-tidy finds something. `make tidy` without a
commit takes hours, as it looks at tests, too.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/tidy"
ROOMS = ["soms", "apps", "thesis"]
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def changed(since):
    """Files that differ from a commit, those that are not committed yet included."""
    out = ""
    for command in (["diff", "--name-only", "--diff-filter=d", since], ["ls-files", "--others", "--exclude-standard"]):
        out += subprocess.run(["git", *command, "--", *ROOMS], cwd=ROOT, stdout=subprocess.PIPE, check=True, text=True).stdout
    return set(out.split("\n"))


def compiled():
    """Sources of these rooms that the build compiles, sorted."""
    commands = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))
    files = {pathlib.Path(command["file"]) for command in commands}
    return sorted(str(file.relative_to(ROOT)) for file in files
                  if any(file.is_relative_to(ROOT / room) for room in ROOMS))


def to_look_at(since):
    sources = compiled()
    if not since:
        return sources
    files = changed(since)
    chosen = files.intersection(sources)
    includes = {source: set(INCLUDE.findall((ROOT / source).read_text(encoding="utf-8"))) for source in sources}
    seen = set().union(*(includes[source] for source in chosen))
    for header in sorted(file for file in files - seen if file.endswith(".h")):
        users = [source for source in sources if header in includes[source]]
        if users and not chosen.intersection(users):
            chosen.add(users[0])
    return sorted(chosen)


def complaints(source):
    """What clang-tidy says of a source; nothing if all is well."""
    done = subprocess.run(["clang-tidy", "--quiet", "-p", str(BUILD), source], cwd=ROOT, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, check=False)
    return "" if done.returncode == 0 else done.stdout + done.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("since", nargs="?", metavar="SINCE", help="a commit; by default all sources")
    parser.add_argument("--jobs", "-j", default=os.cpu_count(), type=int, help="sources looked at at once")
    wanted = parser.parse_args()
    sources = to_look_at(wanted.since)
    faulty = 0
    with concurrent.futures.ThreadPoolExecutor(wanted.jobs) as workers:
        for number, (source, said) in enumerate(zip(sources, workers.map(complaints, sources)), 1):
            print(f"[{number} of {len(sources)}] {source}\n{said}", end="", flush=True)
            faulty += bool(said)
    print(f"{len(sources)} sources, {faulty} with complaints")
    return 1 if faulty else 0


if __name__ == "__main__":
    sys.exit(main())
