"""The examples on top of public headers: each is compiled, runs, and prints what its comment shows.

A `\\file` comment holds the example, statements for a function, and below it what it
prints:

    /// \\code
    /// std::cout << 1 + 1 << '\\n';
    /// \\endcode
    /// It prints:
    /// \\verbatim
    /// 2
    /// \\endverbatim

Every header of ROOMS that soms/soms.h includes has one, but for those of WITHOUT. Others may have one.
"""
import pathlib
import re
import subprocess
import tempfile

ROOMS = ("query", "scene", "clash", "robot")
WITHOUT = {  # a header, and why it has no example
    "soms/clash/print.h": "prints values",
    "soms/query/print.h": "prints values",
    "soms/robot/print.h": "prints values",
    "soms/scene/body_queries.h": "queries of body_index.h and scene.h",
    "soms/scene/of_bodies.h": "answers of body_index.h and scene.h",
    "soms/scene/print.h": "prints values",
    "soms/scene/replay.h": "reads what recording.h writes, as in docs/recording.md",
    "soms/scene/scene_query.h": "answers of scene.h",
    "soms/scene/step_report.h": "answers of scene.h",
}
LINES = range(3, 13)
INCLUDED = re.compile(rf'^#include "(soms/(?:{"|".join(ROOMS)})/\w+\.h)"$', re.MULTILINE)
EXAMPLE = re.compile(r"/// \\code\n(.*?)/// \\endcode\n/// It prints:\n/// \\verbatim\n(.*?)/// \\endverbatim\n",
                     re.DOTALL)


def uncommented(text):
    return re.sub(r"^/// ?", "", text, flags=re.MULTILINE)


def file_comment(text):
    return text.split("#pragma once")[0]


class Example:
    """The example of a header; `fault` says what is wrong with its form, or is empty."""

    def __init__(self, root, name):
        self.name, self.code, self.printed, self.line, self.fault = name, "", "", 0, ""
        text = file_comment((root / name).read_text(encoding="utf-8"))
        found = EXAMPLE.search(text)
        if not found:
            self.fault = "no example in its \\file comment"
            return
        self.code, self.printed = uncommented(found[1]), uncommented(found[2])
        self.line = text[:found.start(1)].count("\n") + 1
        if len(self.code.splitlines()) not in LINES:
            self.fault = f"an example of {len(self.code.splitlines())} lines, not {LINES[0]} to {LINES[-1]}"


def examples(root):
    """Those of all headers that must have one, and of others that have one."""
    names = set(INCLUDED.findall((root / "soms/soms.h").read_text(encoding="utf-8"))) - set(WITHOUT)
    names |= {header.relative_to(root).as_posix() for header in root.glob("soms/**/*.h")
              if r"\code" in file_comment(header.read_text(encoding="utf-8"))}
    return [Example(root, name) for name in sorted(names)]


def program(found):
    """All examples as one program, which runs the one whose number it gets."""
    lines = ["#include <soms/soms.h>", "#include <iostream>", "#include <sstream>", "#include <string>", "#include <vector>"]
    for number, example in enumerate(found):
        lines += [f"static void example_{number}() {{", f'#line {example.line} "{example.name}"',
                  example.code.rstrip("\n"), "}"]
    lines += ["int main(int, char** words) {", "switch (std::stoi(words[1])) {",
              *(f"case {number}: example_{number}(); break;" for number in range(len(found))), "}", "}"]
    return "\n".join(lines) + "\n"


def run(found, compile_command, libraries):
    """What is wrong with each example, from the one program of all: a line of text each."""
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder) / "examples"
        done = subprocess.run([*compile_command, "-", "-xnone", "-o", made, *libraries, "-pthread"],
                              input=program(found), text=True, capture_output=True, check=False)
        if done.returncode:
            yield done.stderr
            return
        for number, example in enumerate(found):
            ran = subprocess.run([made, str(number)], text=True, capture_output=True, check=False,
                                 cwd=folder)
            if ran.returncode or ran.stdout != example.printed:
                yield (f"{example.name}:{example.line}: status {ran.returncode}, printed:\n"
                       f"{ran.stdout}{ran.stderr}")


def faults(root, compile_command, libraries):
    """What is wrong with the examples of the headers of `root`, and how many there are."""
    found = examples(pathlib.Path(root))
    wrong = [f"{example.name}: {example.fault}" for example in found if example.fault]
    wrong += run([example for example in found if not example.fault], compile_command, libraries)
    return wrong, len(found)
