"""Every program that docs/ shows is C++ that soms' headers accept. (That of README is built and run
by tests/install.)

usage: programs_test.py ROOT COMPILER
"""
import pathlib
import re
import subprocess
import sys


def main():
    root, compiler = pathlib.Path(sys.argv[1]), sys.argv[2]
    seen, failed = 0, 0
    for page in sorted(root.glob("docs/*.md")):
        for program in re.findall(r"^```cpp\n(.*?)^```", page.read_text(encoding="utf-8"),
                                  re.DOTALL | re.MULTILINE):
            if "int main(" not in program:
                continue
            seen += 1
            done = subprocess.run(
                [compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", f"-I{root}",
                 "-xc++", "-"], input=program, text=True, capture_output=True, check=False)
            failed += done.returncode != 0
            print(f"{page.name}: {'wrong' if done.returncode else 'right'}", done.stderr, sep="\n")
    print(f"{seen} programs, {failed} wrong")
    return 1 if failed or not seen else 0


if __name__ == "__main__":
    sys.exit(main())
