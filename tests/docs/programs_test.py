"""Every program that docs/ shows is C++ that soms' headers accept, and one that the page follows with
"It prints:" and a block of text prints that. The examples on top of public headers run and print what
their comments show, too (header_examples.py). (The program of README is built and run by tests/install.)

usage: programs_test.py ROOT COMPILER [FLAG...] [-- LIBRARY...]

FLAGs are for the compiler: where Eigen is, without which programs of soms/adapt are skipped. LIBRARIES
are what a program links.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

import header_examples

PROGRAM = re.compile(r"^```cpp\n(.*?)^```\n(?:\nIt prints:\n\n```text\n(.*?)^```)?",
                     re.DOTALL | re.MULTILINE)


def fault_of(program, printed, compile_command, libraries):
    """What is wrong with a program; empty if nothing is."""
    if printed is None:
        done = subprocess.run([*compile_command, "-fsyntax-only", "-"], input=program, text=True,
                              capture_output=True, check=False)
        return done.stderr if done.returncode else ""
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder) / "program"
        done = subprocess.run([*compile_command, "-", "-xnone", "-o", made, *libraries, "-pthread"],
                              input=program, text=True, capture_output=True, check=False)
        if done.returncode:
            return done.stderr
        done = subprocess.run([made], text=True, capture_output=True, check=False, cwd=folder)
        if done.returncode or done.stdout != printed:
            return f"status {done.returncode}, printed:\n{done.stdout}{done.stderr}"
    return ""


def compile_command_of(root, compiler, flags, folder):
    """How programs are compiled: with all of soms' headers precompiled in a folder, which compilers
    take where a program includes <soms/soms.h> first, as nearly all do."""
    command = [compiler, "-std=c++20", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", f"-I{root}",
               *flags]
    every = pathlib.Path(folder) / "soms" / "soms.h"
    every.parent.mkdir()
    every.write_text(f'#include "{pathlib.Path(root).resolve()}/soms/soms.h"\n', encoding="utf-8")
    subprocess.run([*command, "-xc++-header", every, "-o", every.with_suffix(".h.gch")], check=True)
    return [*command[:1], f"-I{folder}", *command[1:], "-xc++"]


def main():
    root, compiler, *rest = sys.argv[1:]
    cut = rest.index("--") if "--" in rest else len(rest)
    flags, libraries = rest[:cut], rest[cut + 1:]
    with tempfile.TemporaryDirectory() as folder:
        command = compile_command_of(root, compiler, flags, folder)
        return max(check_headers(root, command, libraries), check_pages(root, command, flags, libraries))


def check_headers(root, compile_command, libraries):
    """The exit status: 1 if a public header has no example, or one that is wrong."""
    wrong, count = header_examples.faults(root, compile_command, libraries)
    print(*wrong, f"{count} headers, {len(wrong)} examples wrong", sep="\n")
    return 1 if wrong or not count else 0


def check_pages(root, compile_command, flags, libraries):
    """The exit status: 1 if a program of a page is wrong."""
    seen, ran, failed = 0, 0, 0
    for page in sorted(pathlib.Path(root).glob("docs/*.md")):
        for program, printed in PROGRAM.findall(page.read_text(encoding="utf-8")):
            if "int main(" not in program:
                continue
            if "<soms/adapt/" in program and not flags:
                print(f"{page.name}: skipped, as Eigen is missing")
                continue
            seen += 1
            ran += bool(printed)
            fault = fault_of(program, printed or None, compile_command, libraries)
            failed += bool(fault)
            print(f"{page.name}: {'wrong' if fault else 'right'}", fault, sep="\n")
    print(f"{seen} programs, {ran} of them run, {failed} wrong")
    return 1 if failed or not ran else 0


if __name__ == "__main__":
    sys.exit(main())
