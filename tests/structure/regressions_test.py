"""docs/regressions.md and the tests named R01 to R124 agree.

Every id stands once, in order; a row that says "tested" or "in part" names all tests of its id, and
no other row has any; a verb that is called missing is missing. With --write the names are filled in.
"""
import pathlib
import re
import sys

ROW = re.compile(r"^\| (R\d+) \| (.+) \| (.+) \| (.+) \|(.*)\|$", re.MULTILINE)
CPP = re.compile(r"\bTEST(?:_F|_P)?\(\s*(\w+),\s*((R\d+)[A-Z]\w*)")
CMAKE = re.compile(r"\bNAME\s+(\w+)\.((R\d+)[A-Z]\w*)")
VERB = re.compile(r'Verb\{"([\w-]+)"')
LAST = 124
THREAD = r"[\w.-]+/[\w.-]+#\d+"
# Where a fault was reported: threads of others, or by ourselves.
SOURCES = re.compile(rf"{THREAD}(, {THREAD})*|our prototypes|soms \d+\.\d+\.\d+")
STATES = ("tested", "in part; not yet offered: ", "not yet offered: ", "does not apply: ")


def tests_of(root):
    """Names of tests by id, sorted."""
    found = {}
    for file in sorted((root / "tests").rglob("*")):
        pattern = {".cpp": CPP, ".txt": CMAKE}.get(file.suffix)
        if pattern is None:
            continue
        for suite, name, identity in pattern.findall(file.read_text(encoding="utf-8")):
            found.setdefault(identity, set()).add(f"`{suite}.{name}`")
    return {identity: sorted(names) for identity, names in found.items()}


def faults(page, tests, verbs):
    rows = ROW.findall(page)
    ids = [row[0] for row in rows]
    expected = [f"R{i:02}" for i in range(1, LAST + 1)]
    if ids != expected:
        yield f"rows are not R01 to R{LAST}: {sorted(set(expected) ^ set(ids))}"
    for identity in sorted(set(tests) - set(expected)):
        yield f"{identity} has tests and no row"
    for identity, _, threads, state, named in rows:
        names = tests.get(identity, [])
        if not SOURCES.fullmatch(threads):
            yield f"{identity}: names no thread"
        if not any(state == s if s == "tested" else state.startswith(s) for s in STATES):
            yield f"{identity}: unknown state {state}"
        if state.startswith(("tested", "in part")) and not names:
            yield f"{identity}: is said to be tested, and no test has its number"
        if not state.startswith(("tested", "in part")) and names:
            yield f"{identity}: is said to be {state}, but there are {names}"
        if named.strip() != ", ".join(names):
            yield f"{identity}: run tests/structure/regressions_test.py . --write"
        if "not yet offered" in state:
            for verb in set(re.findall(r"`([\w-]+)`", state)) & verbs:
                yield f"{identity}: {verb} is offered now"


def written(page, tests):
    def fill(match):
        head = " | ".join(match.group(1, 2, 3, 4))
        names = ", ".join(tests.get(match.group(1), []))
        return f"| {head} | {names} |" if names else f"| {head} | |"

    return ROW.sub(fill, page)


def main():
    root = pathlib.Path(sys.argv[1])
    path = root / "docs" / "regressions.md"
    page = path.read_text(encoding="utf-8")
    tests = tests_of(root)
    if "--write" in sys.argv[2:]:
        page = written(page, tests)
        path.write_text(page, encoding="utf-8")
    verbs = set(VERB.findall((root / "apps/soms/shell/verbs.cpp").read_text(encoding="utf-8")))
    if "info" not in verbs:
        print("no verbs found in apps/soms/shell/verbs.cpp")
        return 1
    found = list(faults(page, tests, verbs))
    for line in found:
        print(line)
    print(f"{sum(map(len, tests.values()))} tests, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
