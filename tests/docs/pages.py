"""The examples of a page: its blocks of code, and what comments above them say of them."""
import re

SHELL = {"sh", "bash", "shell", "console"}
PLAIN = {"", "text"}  # what may be an example or what it prints
CALL = re.compile(r"(^|[|;&(])[ \t]*soms(?![-\w/.])", re.MULTILINE)
BUILD = re.compile(r"^(make|cmake)( |$)", re.MULTILINE)
MARK = re.compile(r"<!-- (not run|printed by|file|not printed): (.+) -->")


class Block:
    """`mark` is one of MARK's words, or empty; `value` what follows it. `of_program`: it is what the
    program in C++ or Python right above it prints, which tests of these programs compare."""

    def __init__(self, number, language, text, mark, value):
        self.number, self.language, self.text = number, language, text
        self.mark, self.value = mark, value
        self.of_program = False

    def is_example(self):
        """To be run, unless a mark says why not."""
        return self.mark in {"", "not run"} and bool(
            (self.language in SHELL or not self.language) and CALL.search(self.text))

    def fault(self):
        """What keeps a reader from trusting this block, or None."""
        if self.language not in SHELL | PLAIN or self.mark or self.of_program or self.is_example():
            return None
        if self.language in SHELL or BUILD.search(self.text):
            return "is not run: say why, <!-- not run: REASON -->"
        return ("is compared with nothing: <!-- printed by: COMMAND -->, <!-- file: NAME --> or "
                "<!-- not printed: REASON -->")


def code_span(lines):
    """The first code span of a paragraph that is an object of JSON."""
    found = re.search(r"`(\{[^`]*\})`", "\n".join(lines))
    return found[1] if found else None


def blocks(text):
    """Fenced blocks, indented ones, and paragraphs below `printed by`, whose object of JSON counts."""
    found, lines, mark, at = [], text.splitlines(), ("", ""), 0
    before, program = "", False
    while at < len(lines):
        line, begin = lines[at], at
        comment, fence = MARK.fullmatch(line.strip()), re.fullmatch(r"( *)```(\w*)", line)
        if comment:
            mark = comment.groups()
        elif fence:
            at += 1
            while at < len(lines) and lines[at].strip() != "```":
                at += 1
            inside = "\n".join(row.removeprefix(fence[1]) for row in lines[begin + 1:at])
            found.append(Block(begin + 1, fence[2], inside, *mark))
            found[-1].of_program = fence[2] == "text" and program
            program = fence[2] in {"cpp", "python"}
        elif line.startswith("    ") and not before:
            while at < len(lines) and (lines[at].startswith("    ") or not lines[at].strip()):
                at += 1
            inside = "\n".join(row[4:] for row in lines[begin:at]).rstrip()
            found.append(Block(begin + 1, "", inside, *mark))
            at -= 1
        elif line.strip() and mark[0] == "printed by":
            while at < len(lines) and lines[at].strip():
                at += 1
            found.append(Block(begin + 1, "json", code_span(lines[begin:at]) or "", *mark))
            at -= 1
        if line.strip() and not comment:
            mark = ("", "")
            program = program and (fence or line == "It prints:")
        before = lines[at].strip() if at < len(lines) and not comment else ""
        at += 1
    return found
