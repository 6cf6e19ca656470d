"""A program that a page of docs/ shows, and what the page says that it prints.

The block fenced as cpp holds the program; where the next block is fenced as text, it is the output.

usage: page_program.py source PAGE NUMBER    print program NUMBER of the page, counted from 1
       page_program.py run PAGE NUMBER EXE   run EXE, which was built from it, and compare
"""
import pathlib
import re
import subprocess
import sys


def programs(page):
    """Each program of the page with its output, or None."""
    blocks = re.findall(r"^```(\w*)\n(.*?)^```", page.read_text(encoding="utf-8"),
                        re.DOTALL | re.MULTILINE)
    for at, (kind, text) in enumerate(blocks):
        if kind == "cpp" and "int main(" in text:
            behind = blocks[at + 1] if at + 1 < len(blocks) else ("", "")
            yield text, behind[1] if behind[0] == "text" else None


def main():
    task, page, number = sys.argv[1], pathlib.Path(sys.argv[2]), int(sys.argv[3])
    source, output = list(programs(page))[number - 1]
    if task == "source":
        print(source, end="")
        return 0
    if output is None:
        print(f"{page.name}: no output stands behind program {number}")
        return 1
    done = subprocess.run([sys.argv[4]], text=True, capture_output=True, check=False)
    print(done.stdout, done.stderr, sep="")
    if done.returncode != 0 or done.stdout != output:
        print(f"{page.name}: program {number} ended with status {done.returncode}; the page shows\n{output}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
