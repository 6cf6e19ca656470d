"""Every example of README and docs/ runs as it is printed, prints what the page shows, and every verb has a page with one.

A block fenced as `sh` or indented that calls soms is run, whole. The blocks of a page run in their
order in one folder of their own, which is empty at first: a page makes the files that it uses. What
is said of a block stands above it in a comment, which readers of the page do not see:

<!-- not run: reason -->      a test cannot run it
<!-- printed by: command -->  it shows what the command prints, compared by the rule in printed.py.
                              Above a paragraph: its object of JSON does
<!-- file: name -->           it is a file that later examples read
<!-- not printed: reason -->  it shows no output

A block without a language, of `text` or of `sh` needs one of these unless it is run.

usage: examples_test.py ROOT COMMAND [PAGE...]   (without pages: all of them, and every verb)
"""
import concurrent.futures
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from pages import SHELL, blocks
from printed import difference

SECONDS = 1200  # of one block, a guard; all of them together take a few
PAGES_OF_VERBS = dict.fromkeys(["completion", "man", "version"], "docs/install.md") | {"within": "docs/distance.md", "robot": "docs/robots.md", "join": "docs/scale.md", "build": "docs/tree_file.md", "tile": "docs/tiles.md"}  # others: docs/VERB.md
NEEDS_VIEWER = re.compile(r"\bsoms (view|render)\b|--view\b|--picture\b|\bsoms simulate\b.*\.png\b")
NEEDS_DISPLAY = re.compile(r"\bsoms view\b|--view\b")
NEEDS_BENCH = re.compile(r"\bsoms bench\b")
# docs/README.md says "Your own files": these stand for them.
YOURS = {
    "walls.obj": ["generate", "knot", "--triangles", "200"],
    "pipes.glb": ["generate", "sphere", "--triangles", "200"],
    "tool.stl": ["generate", "knot", "--triangles", "200"],
    "cell.ply": ["generate", "sphere", "--triangles", "200"],
    "model.3ds": ["generate", "teapot", "--triangles", "992"],
    "city.ply": ["generate", "city", "--triangles", "3000"],
    "van.3ds": ["generate", "drone"],
    "poses.csv": "x,y,z\n0.5,0,0\n0,0.5,0\n9,0,0\n",
}
PAGE_OF_YOURS = "docs/README.md"
PAGE_OF_BUILDS = "README.md"
# Stands for the command and notes what it did: "VERB STATUS", a line each.
WRAPPER = """#!/bin/sh
"$SOMS_REAL" "$@"
status=$?
echo "$1 $status" >> "$SOMS_RAN"
exit $status
"""
PREAMBLE = "set -euo pipefail; trap 'echo \"status $? of: $BASH_COMMAND\" >&2' ERR\n"


class Display:
    """An X server without a screen, where there is one: `name` is empty otherwise."""

    def __init__(self):
        self.name, self.server = "", None
        if shutil.which("Xvfb"):
            reading, writing = os.pipe()
            self.server = subprocess.Popen(
                ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x720x24"],
                pass_fds=[writing], stderr=subprocess.DEVNULL)
            os.close(writing)
            number = os.fdopen(reading).readline().strip()
            self.name = f":{number}" if number else ""

    def close(self):
        if self.server:
            self.server.terminate()
            self.server.wait()


class Page:
    def __init__(self, root, name, folder):
        self.name = name
        self.text = (root / name).read_text(encoding="utf-8")
        self.folder = folder / name.replace("/", "_")
        self.ran = folder / (name.replace("/", "_") + ".ran")
        self.faults, self.report, self.seconds = [], [], 0.0
        self.examples, self.compared = 0, 0

    def verbs(self):
        """Verbs that this page's examples called with success."""
        lines = self.ran.read_text(encoding="utf-8").splitlines() if self.ran.exists() else []
        return {line.split()[0] for line in lines if line.endswith(" 0")}

    def bash(self, script, environment):
        """Status and output of a script in the page's folder."""
        begin = time.monotonic()
        process = subprocess.Popen(["bash", "-c", script], cwd=self.folder,
                                   env=environment | {"SOMS_RAN": str(self.ran)},
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, text=True, start_new_session=True)
        try:
            output, _ = process.communicate(timeout=SECONDS)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            output, _ = process.communicate()
            output += f"\nended after {SECONDS} s"
        self.seconds += time.monotonic() - begin
        return process.returncode, output

    def run_block(self, block, environment):
        begin = self.seconds
        status, output = self.bash(PREAMBLE + block.text, environment)
        self.examples += 1
        self.report.append(f"{self.name}, line {block.number}: {self.seconds - begin:.2f} s")
        if status != 0:
            self.faults.append(f"{self.name}, line {block.number}: status {status}\n"
                               f"{block.text}\n--\n{output[-3000:]}")

    def compare(self, block, environment):
        """With what the command prints, whatever its status: messages of errors are shown, too."""
        _, output = self.bash(block.value, environment)
        found = difference(block.text, output) if block.text else "no block and no object of JSON follows"
        self.compared += 1
        self.report.append(f"{self.name}, line {block.number}: compared with {block.value}")
        if found:
            self.faults.append(f"{self.name}, line {block.number}: not what is printed by {block.value}\n"
                               f"{found}\n--\n{output[-3000:]}")

    def run(self, environment, yours, missing):
        """`missing(text)` says why an example cannot run here, or nothing."""
        self.folder.mkdir()
        if self.name == PAGE_OF_YOURS:
            shutil.copytree(yours, self.folder, dirs_exist_ok=True)
        for block in blocks(self.text):
            if block.mark == "file":
                (self.folder / block.value).write_text(block.text + "\n", encoding="utf-8")
                continue
            fault = block.fault()
            builds = self.name == PAGE_OF_BUILDS and block.language in SHELL
            if fault and not builds:  # the README's first commands: tests/install/bare_debian_test.py
                self.faults.append(f"{self.name}, line {block.number}: {fault}\n{block.text}")
            reason = block.value if block.mark == "not run" else missing(block.text + block.value)
            if (block.is_example() or block.mark == "printed by") and reason:
                self.report.append(f"{self.name}, line {block.number}: not run: {reason}")
            elif block.mark == "printed by":
                self.compare(block, environment)
            elif block.is_example():
                self.run_block(block, environment)
        return self


def prepare(command, folder):
    folder.mkdir()
    for name, how in YOURS.items():
        if isinstance(how, str):
            (folder / name).write_text(how, encoding="utf-8")
        else:
            subprocess.run([command, *how, "-q", "-o", folder / name], check=True)


def verbs_of(command):
    text = subprocess.run([command, "--help"], check=True, capture_output=True, text=True).stdout
    listed = text.split("Verbs:\n", 1)[1].split("\n\n", 1)[0]
    return [line.split()[0] for line in listed.splitlines()]


def missing_here(command, display):
    """A function that says why an example cannot run on this machine, or nothing."""
    viewer = (command.parent / "soms-view").exists()
    bench = (command.parent / "soms-bench").exists()

    def missing(text):
        if NEEDS_VIEWER.search(text) and not viewer:
            return "soms-view was not built"
        if NEEDS_DISPLAY.search(text) and not display:
            return "Xvfb is missing: install the packages of section test"
        if NEEDS_BENCH.search(text) and not bench:
            return "soms-bench was not built"
        return ""
    return missing


def missing_pages(root, command, pages, missing):
    """A line for each verb without a page, or without an example there that ran."""
    ran = {page.name: page.verbs() for page in pages}
    for verb in verbs_of(command):
        page = PAGES_OF_VERBS.get(verb, f"docs/{verb}.md")
        if not (root / page).exists():
            yield f"soms {verb} has no page {page}"
        elif verb not in ran[page] and not missing(f"soms {verb}"):
            yield f"{page} has no example of soms {verb} that ran"


def main():
    root, command = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    chosen = sys.argv[3:]
    names = chosen or ["README.md", *(f"docs/{f.name}" for f in sorted(root.glob("docs/*.md")))]
    display = Display()
    missing = missing_here(command, display.name)
    try:
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            (folder / "bin").mkdir()
            (folder / "bin/soms").write_text(WRAPPER, encoding="utf-8")
            (folder / "bin/soms").chmod(0o755)
            (folder / "home").mkdir()
            prepare(command, folder / "prepared")
            environment = {
                "PATH": f"{folder}/bin:/usr/local/bin:/usr/bin:/bin", "HOME": f"{folder}/home",
                "SOMS_REAL": str(command), "LC_ALL": "C.UTF-8", "DISPLAY": display.name,
                "LIBGL_ALWAYS_SOFTWARE": "1",
                "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "")}
            pages = [Page(root, name, folder) for name in names]
            with concurrent.futures.ThreadPoolExecutor(2) as pool:
                list(pool.map(lambda page: page.run(environment, folder / "prepared", missing),
                              pages))
            faults = [fault for page in pages for fault in page.faults]
            if not chosen:
                faults += missing_pages(root, command, pages, missing)
    finally:
        display.close()
    print(*(line for page in pages for line in page.report), *faults, sep="\n")
    ran = sum(page.examples for page in pages)
    compared = sum(page.compared for page in pages)
    print(f"{ran} examples and {compared} comparisons in {sum(page.seconds for page in pages):.1f} s, "
          f"{len(faults)} faults")
    return 1 if faults or not ran else 0


if __name__ == "__main__":
    sys.exit(main())
