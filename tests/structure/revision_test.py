"""cmake/revision.cmake names the commit of a checkout, and "unknown" elsewhere; a header that is right is not touched.

usage: revision_test.py SOURCE CMAKE
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile


def git(folder, *words):
    # Nothing of the user's settings, and no repository of an outer git command.
    environment = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    environment |= {"GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_SYSTEM": os.devnull}
    return subprocess.run(["git", "-c", "user.name=n", "-c", "user.email=e@localhost", *words], cwd=folder,
                          check=True, capture_output=True, text=True, env=environment).stdout.strip()


class Script:
    def __init__(self, root, cmake, header):
        self.words = [cmake, "-D", f"HEADER={header}", "-P", root / "cmake/revision.cmake"]
        self.header = header

    def commit(self, folder):
        subprocess.run([self.words[0], "-D", f"SOURCE={folder}", *self.words[1:]], check=True)
        return re.fullmatch(r'#define SOMS_COMMIT "(.+)"\n', self.header.read_text("utf-8")).group(1)


def faults(script, folder):
    if script.commit(folder) != "unknown":
        yield "a folder that is no checkout has a commit"
    git(folder, "init", "-q")
    (folder / "file").write_text("one", encoding="utf-8")
    (folder / "inner").mkdir()
    (folder / "inner/file").write_text("two", encoding="utf-8")
    git(folder, "add", "."), git(folder, "commit", "-q", "-m", "one"), git(folder, "tag", "-a", "v1", "-m", "v1")
    head = git(folder, "rev-parse", "HEAD")
    if script.commit(folder) != head:
        yield f"{script.commit(folder)} is not {head}"
    before = script.header.stat().st_mtime_ns
    script.commit(folder)
    if script.header.stat().st_mtime_ns != before:
        yield "the header is written though nothing changed"
    if script.commit(folder / "inner") != "unknown":
        yield "a folder inside another project's checkout has its commit"
    (folder / "file").write_text("changed", encoding="utf-8")
    if script.commit(folder) != head + "-dirty":
        yield f"{script.commit(folder)} after a change"


def main():
    if shutil.which("git") is None:
        print("skipped: git is not installed")
        return 77
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name).resolve()
        (work / "source").mkdir()
        found = list(faults(Script(pathlib.Path(sys.argv[1]), sys.argv[2], work / "revision.h"), work / "source"))
    for fault in found:
        print(fault)
    print(f"{len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
