#!/usr/bin/env python3
"""Puts faults into the library, one at a time, and tells which test finds each.

The lists are tools/faults/*.toml. The working tree is copied to build/faults/tree and built there, so
nothing else is touched. Each fault is built there with the programs that its
tests are part of; these must pass without it and one of them must fail with it. Ends with status 1
if a fault is not found, does not apply or does not build.

A new fault is a table, at the end of a list, or in a list of its own:

  [[fault]]
  name = "slack-without-rounding"               # letters, digits and dashes; unique
  file = "soms/query/detail/relative_pose.cpp"  # where it goes
  old = '''192 * kUnitRoundoff'''               # the text as it is, found exactly once in the file
  new = '''1 * kUnitRoundoff'''                 # and with the fault
  tests = ["query_test Overlap.KeepsBodies"]    # program and test; the likeliest first
  why = "moved vertices are rounded"            # what goes wrong, for docs/trust.md

It must compile without warnings. Then: tools/faults.py --only NAME to try it, and tools/faults.py --write docs/trust.md.
"""
import argparse
import collections
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
LISTS = ROOT / "tools/faults"
WORK = ROOT / "build/faults"
TREE = WORK / "tree"
BUILD = TREE / "build/release"
PAGE = ROOT / "docs/trust.md"
BEGIN = "<!-- faults: written by tools/faults.py -->"
END = "<!-- end of faults -->"
FIELDS = {"name", "file", "old", "new", "tests", "why"}
HANG = 3600  # seconds; a test that takes longer has found the fault by hanging
TEST = re.compile(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", re.MULTILINE)


def faults():
    """All faults, in the order of the lists."""
    return [fault for path in sorted(LISTS.glob("*.toml"))
            for fault in tomllib.loads(path.read_text(encoding="utf-8"))["fault"]]


def occurrences(fault, root):
    path = root / fault["file"]
    return path.read_text(encoding="utf-8").count(fault["old"]) if path.is_file() else 0


def table(listed):
    lines = ["| fault | what goes wrong | found by |", "|---|---|---|"]
    for fault in listed:
        found_by = ", ".join(f"`{test.split()[1]}`" for test in fault["tests"])
        lines.append(f"| `{fault['name']}` | {fault['why']} | {found_by} |")
    return lines


def page_with_table(text, listed):
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    return before + "\n".join([BEGIN, "", *table(listed), "", END]) + after


def complaints(listed):
    """What is wrong with the lists themselves. Cheap: nothing is built."""
    tests = {f"{suite}.{name}" for path in sorted((ROOT / "tests").rglob("*.cpp"))
             for suite, name in TEST.findall(path.read_text(encoding="utf-8"))}
    for name, number in collections.Counter(fault["name"] for fault in listed).items():
        if number > 1 or not re.fullmatch(r"[a-z0-9-]+", name):
            yield f"{name}: not a name, or not the only one"
    for fault in listed:
        if set(fault) != FIELDS or not fault["tests"] or fault["old"] == fault["new"]:
            yield f"{fault['name']}: not all of {', '.join(sorted(FIELDS))}, or nothing changes"
            continue
        if occurrences(fault, ROOT) != 1:
            yield f"{fault['name']}: {fault['file']} has the old text {occurrences(fault, ROOT)} times, not once"
        for test in fault["tests"]:
            if len(test.split()) != 2 or test.split()[1] not in tests:
                yield f"{fault['name']}: no such test: {test}"
    text = PAGE.read_text(encoding="utf-8")
    if page_with_table(text, listed) != text:
        yield "docs/trust.md: the table is out of date: tools/faults.py --write docs/trust.md"


def copy_tree():
    """Brings the copy up to date; files that are equal keep their times, so they are not built again."""
    out = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                         cwd=ROOT, stdout=subprocess.PIPE, check=True).stdout.decode()
    names = {name for name in out.split("\0") if (ROOT / name).is_file()}
    for path in [path for path in TREE.rglob("*") if path.is_file()]:
        if not path.is_relative_to(BUILD) and str(path.relative_to(TREE)) not in names:
            path.unlink()
    for name in sorted(names):
        there = TREE / name
        if not there.is_file() or there.read_bytes() != (ROOT / name).read_bytes():
            there.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, there)
            shutil.copymode(ROOT / name, there)


def run(command, log):
    """Exit status and output; the output goes to a log, too."""
    process = subprocess.run([str(part) for part in command], cwd=TREE, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, check=False)
    log.write_bytes(process.stdout)
    return process.returncode, process.stdout.decode(errors="replace")


def configure(chosen):
    # The viewer is built only for faults that its tests find.
    view = any(test.startswith("view_") for fault in chosen for test in fault["tests"])
    command = ["cmake", "--preset", "release", "-S", TREE, "-D", "SOMS_BUILD_TESTS=ON",
               "-D", f"SOMS_BUILD_VIEW={'ON' if view else 'OFF'}"]
    if shutil.which("ccache"):
        command += ["-D", "CMAKE_CXX_COMPILER_LAUNCHER=ccache"]
    if run(command, WORK / "configure.log")[0] != 0:
        sys.exit(f"cmake failed: {WORK / 'configure.log'}")


def build(tests, jobs, name):
    programs = sorted({test.split()[0] for test in tests})
    return run(["cmake", "--build", BUILD, "-j", jobs, "--target", *programs], WORK / f"{name}.build.log")[0] == 0


def failure(test, name):
    """How a test fails: its name and, unless it reports so itself, how it ended. None if it passes."""
    program, which = test.split()
    path = next(path for path in BUILD.rglob(program) if path.is_file() and os.access(path, os.X_OK))
    command = [path, f"--gtest_filter={which}", "--gtest_brief=1"]
    try:
        process = subprocess.run([str(part) for part in command], cwd=WORK, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, timeout=HANG, check=False)
    except subprocess.TimeoutExpired:
        return f"{which} (hangs)"
    out = process.stdout.decode(errors="replace")
    (WORK / f"{name}.test.log").write_text(out)
    if process.returncode == 0:
        # A filter that matches nothing passes.
        return None if "1 test." in out else f"{which} (is not a test of {program})"
    return which if "[  FAILED  ]" in out else f"{which} (ends with status {process.returncode})"


def check_without_faults(listed, jobs):
    tests = list(dict.fromkeys(test for fault in listed for test in fault["tests"]))
    print(f"without faults: {len(tests)} tests", flush=True)
    if not build(tests, jobs, "none"):
        sys.exit(f"the tree does not build: {WORK / 'none.build.log'}")
    for test in tests:
        if (how := failure(test, "none")) is not None:
            sys.exit(f"fails without any fault: {how}")


def verdict(fault, jobs):
    """"found by ...", or why not."""
    if occurrences(fault, TREE) != 1:
        return "does not apply"
    path = TREE / fault["file"]
    whole = path.read_text(encoding="utf-8")
    try:
        path.write_text(whole.replace(fault["old"], fault["new"]), encoding="utf-8")
        if not build(fault["tests"], jobs, fault["name"]):
            return "does not build"
        for test in fault["tests"]:
            if (how := failure(test, fault["name"])) is not None:
                return f"found by {how}"
        return "NOT FOUND"
    finally:
        path.write_text(whole, encoding="utf-8")


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", metavar="NAME", action="append", help="this fault alone; may be given again")
    parser.add_argument("--list", action="store_true", help="print all faults and end")
    parser.add_argument("--check", action="store_true",
                        help="only check that each fault still applies, that its tests exist, and docs/trust.md")
    parser.add_argument("--write", metavar="PAGE", type=pathlib.Path, help="write the table into a page and end")
    parser.add_argument("--jobs", "-j", default=os.cpu_count(), type=int, help="files compiled at once")
    return parser.parse_args()


def main():
    wanted = options()
    listed = faults()
    if wanted.list:
        for fault in listed:
            print(f"{fault['name']:34} {fault['file']}: {fault['why']}")
        return 0
    if wanted.write:
        wanted.write.write_text(page_with_table(wanted.write.read_text(encoding="utf-8"), listed), encoding="utf-8")
        return 0
    if wanted.check:
        found = list(complaints(listed))
        print("\n".join([*found, f"{len(listed)} faults to put in, {len(found)} complaints"]))
        return 1 if found else 0
    chosen = [fault for fault in listed if not wanted.only or fault["name"] in wanted.only]
    if not chosen or len(chosen) < len(set(wanted.only or [])):
        sys.exit("no such fault; --list prints all")
    WORK.mkdir(parents=True, exist_ok=True)
    copy_tree()
    configure(chosen)
    check_without_faults(chosen, wanted.jobs)
    verdicts = {}
    for fault in chosen:
        verdicts[fault["name"]] = verdict(fault, wanted.jobs)
        print(f"{fault['name']:34} {verdicts[fault['name']]}", flush=True)
    missed = sum(not said.startswith("found by") for said in verdicts.values())
    print(f"{len(verdicts)} faults, {missed} not found")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
