"""Every example of README and docs/ runs as it is printed, and every verb has a page with one.

A block fenced as `sh` is run, whole, if one of its lines calls soms. The blocks of a page run in
their order in one folder of their own, which is empty at first but for models that a page uses as
"yours" (PREPARED). A block that a test can't run stands below a comment, which readers do not see:
<!-- not run: reason -->

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

SECONDS = 1200  # of one block, a guard; all of them together take a few
PAGES_OF_VERBS = dict.fromkeys(["completion", "man", "version"], "docs/install.md")  # others: docs/VERB.md
NEEDS_VIEWER = re.compile(r"\bsoms (view|render)\b|--view\b|--picture\b")
NEEDS_DISPLAY = re.compile(r"\bsoms view\b|--view\b")
PREPARED = {
    "tool.stl": ["generate", "knot", "--triangles", "200"],
    "cell.ply": ["generate", "sphere", "--triangles", "200"],
    "model.3ds": ["generate", "teapot", "--triangles", "992"],
    "city.ply": ["generate", "city", "--triangles", "3000"],
    "van.3ds": ["generate", "drone"],
    "poses.csv": "x,y,z\n0.5,0,0\n0,0.5,0\n9,0,0\n",
}
# Stands for the command and notes what it did: "VERB STATUS", a line each.
WRAPPER = """#!/bin/sh
"$SOMS_REAL" "$@"
status=$?
echo "$1 $status" >> "$SOMS_RAN"
exit $status
"""
SHELL = "set -euo pipefail; trap 'echo \"status $? of: $BASH_COMMAND\" >&2' ERR\n"


def blocks(text):
    """(line number, lines, reason why it is not run or None) of each block fenced as sh."""
    inside, reason, found = None, None, []
    for number, line in enumerate(text.splitlines(), 1):
        words = line.strip()
        if inside is not None:
            if words == "```":
                found.append((inside[0], "\n".join(inside[1]), reason))
                inside, reason = None, None
            else:
                inside[1].append(words)
        elif re.fullmatch(r"```(sh|bash|shell|console)", words):
            inside = (number, [])
        elif words:
            told = re.fullmatch(r"<!-- not run: (.+) -->", words)
            reason = told.group(1) if told else None
    return found


def calls_soms(block):
    return re.search(r"(^|[|;&(] *)soms\b", block, re.MULTILINE)


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
        self.faults, self.report, self.seconds, self.examples = [], [], 0.0, 0

    def verbs(self):
        """Verbs that this page's examples called with success."""
        lines = self.ran.read_text(encoding="utf-8").splitlines() if self.ran.exists() else []
        return {line.split()[0] for line in lines if line.endswith(" 0")}

    def run_block(self, number, block, environment):
        begin = time.monotonic()
        process = subprocess.Popen(["bash", "-c", SHELL + block], cwd=self.folder,
                                   env=environment | {"SOMS_RAN": str(self.ran)},
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, text=True, start_new_session=True)
        try:
            output, _ = process.communicate(timeout=SECONDS)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            output, _ = process.communicate()
            output += f"\nended after {SECONDS} s"
        seconds = time.monotonic() - begin
        self.seconds += seconds
        self.examples += 1
        self.report.append(f"{self.name}, line {number}: {seconds:.2f} s")
        if process.returncode != 0:
            self.faults.append(f"{self.name}, line {number}: status {process.returncode}\n"
                               f"{block}\n--\n{output[-3000:]}")

    def run(self, environment, prepared, viewer, display):
        self.folder.mkdir()
        for file in prepared.iterdir():
            if re.search(r"(?<![\w.])" + re.escape(file.name), self.text):
                shutil.copy(file, self.folder)
        for number, block, reason in blocks(self.text):
            if not calls_soms(block):
                continue
            if not reason and NEEDS_VIEWER.search(block) and not viewer:
                reason = "soms-view was not built"
            if not reason and NEEDS_DISPLAY.search(block) and not display:
                reason = "Xvfb is missing: install the packages of section test"
            if reason:
                self.report.append(f"{self.name}, line {number}: not run: {reason}")
            else:
                self.run_block(number, block, environment)
        return self


def prepare(command, folder):
    folder.mkdir()
    for name, how in PREPARED.items():
        if isinstance(how, str):
            (folder / name).write_text(how, encoding="utf-8")
        else:
            subprocess.run([command, *how, "-q", "-o", folder / name], check=True)


def verbs_of(command):
    text = subprocess.run([command, "--help"], check=True, capture_output=True, text=True).stdout
    listed = text.split("Verbs:\n", 1)[1].split("\n\n", 1)[0]
    return [line.split()[0] for line in listed.splitlines()]


def missing_pages(root, command, pages, may_view):
    """A line for each verb without a page, or without an example there that ran."""
    ran = {page.name: page.verbs() for page in pages}
    for verb in verbs_of(command):
        page = PAGES_OF_VERBS.get(verb, f"docs/{verb}.md")
        if not (root / page).exists():
            yield f"soms {verb} has no page {page}"
        elif verb not in ran[page] and (may_view or verb not in {"view", "render"}):
            yield f"{page} has no example of soms {verb} that ran"


def main():
    root, command = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    chosen = sys.argv[3:]
    names = chosen or ["README.md", *(f"docs/{f.name}" for f in sorted(root.glob("docs/*.md")))]
    viewer = (command.parent / "soms-view").exists()
    display = Display()
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
                list(pool.map(lambda page: page.run(environment, folder / "prepared", viewer,
                                                    display.name), pages))
            faults = [fault for page in pages for fault in page.faults]
            if not chosen:
                faults += missing_pages(root, command, pages, viewer and display.name)
    finally:
        display.close()
    print(*(line for page in pages for line in page.report), *faults, sep="\n")
    ran = sum(page.examples for page in pages)
    print(f"{ran} examples in {sum(page.seconds for page in pages):.1f} s, {len(faults)} faults")
    return 1 if faults or not ran else 0


if __name__ == "__main__":
    sys.exit(main())
