"""Each files.cmake lists exactly the files of its folder, or finds them; the tree holds no stray words.

A source that no list names is never built, so its faults are never seen; a listed test that is gone
breaks the build. A folder that finds its files (cmake/find_files.cmake) has no names to compare. Also: no file of the repository promises later work or is overlong.
"""
import pathlib
import re
import sys

MOST_LINES = {".h": 300, ".cpp": 520}
PROMISE = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")


def listed(cmake):
    text = re.sub(r"#.*", "", cmake.read_text(encoding="utf-8"))
    return set(re.findall(r"[\w./-]+\.(?:h|cpp)\b", text))


def unknown_small_files(root):
    """Files that web/CMakeLists.txt names, to be compiled for size, and that are not there."""
    text = (root / "web/CMakeLists.txt").read_text(encoding="utf-8")
    sources = [f"/{f.relative_to(root)}" for f in (root / "soms").rglob("*.cpp")]
    for name in re.search(r"set\(small_files ([^)]*)\)", text).group(1).split():
        if not any(source.endswith(f"/{name}.cpp") for source in sources):
            yield f"web/CMakeLists.txt names {name}.cpp, which is not there"


def faults(root):
    yield from unknown_small_files(root)
    for cmake in sorted([*root.glob("soms/*/files.cmake"), *root.glob("apps/**/files.cmake"),
                         *root.glob("thesis/**/files.cmake"), root / "python/files.cmake"]):
        if "soms_find_files(" in cmake.read_text(encoding="utf-8"):
            continue
        room = cmake.parent
        within = [inner.parent for inner in room.rglob("files.cmake") if inner != cmake]
        there = {str(f.relative_to(room)) for f in room.rglob("*") if f.suffix in {".h", ".cpp"}
                 and not any(inner in f.parents for inner in within)}
        private = {f for f in there if f.endswith(".h") and "detail" in f.split("/")}
        names = listed(cmake)
        for name in sorted(there - names - private):
            yield f"{cmake.relative_to(root)} does not list {name}"
        for name in sorted(names & private):
            yield f"{cmake.relative_to(root)} installs the private header {name}"
    for folder in ("soms", "apps", "thesis", "tests", "bench", "python"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in MOST_LINES:
                continue
            text = file.read_text(encoding="utf-8")
            if len(text.splitlines()) > MOST_LINES[file.suffix]:
                yield f"{file.relative_to(root)} has {len(text.splitlines())} lines"
            if PROMISE.search(text):
                yield f"{file.relative_to(root)} promises later work"
            if not text.isascii():
                yield f"{file.relative_to(root)} is not ASCII"


def main():
    root = pathlib.Path(sys.argv[1])
    found = list(faults(root))
    for line in found:
        print(line)
    print(f"{len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
