"""Sentences are short: at most 30 words, and none begins with "Of ".

Read are the README, the change log, the pages of docs/, the comments of public headers, and the help of the command and
of its verbs. prose_exceptions.csv counts the sentences of each text that break a rule today. A count may
only fall: --write records where it fell, and raises none. Where a header moves, its row moves with it.

usage: prose_test.py ROOT [COMMAND] [--write] [--list NAME...]   (--list: every such sentence of these texts)
"""
import collections
import csv
import pathlib
import re
import subprocess
import sys

MOST_WORDS = 30
LEAST_TEXTS = 100  # of which less would mean that nothing was read
FIELDS = ("text", "long", "fronted")
END = re.compile(r"(?<=[.?!])[)\"]*\s+")
ITEM = re.compile(r"\s*([-*]|\d+\.) +")
PRIVATE = re.compile(r"/(detail|reference)/")


def plain(text):
    """Prose without its marks: a span of code counts as one word, a link as its words."""
    text = re.sub(r"`[^`]*`", "code", text)
    text = re.sub(r"!?\[((?:[^\[\]]|\[[^\]]*\])*)\]\([^)]*\)", r"\1", text)
    return text.replace("*", "")


def paragraphs(lines):
    """Texts of lines that belong together: an item of a list and a cell of a table are each one."""
    text = []
    for line in [*lines, ""]:
        item, row = ITEM.match(line), line.lstrip().startswith("|")
        if (item or row or not line.strip()) and text:
            yield " ".join(text)
            text = []
        if row:
            yield from line.strip().strip("|").split("|")
        elif line.strip():
            text.append(line[item.end():] if item else line.strip())


def page_prose(text):
    """Paragraphs of a page without code, headings and comments."""
    text = re.sub(r"^( *)```.*?^\1```$", "", text, flags=re.DOTALL | re.MULTILINE)
    text = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)
    text = re.sub(r"(?<=\n\n)(?:(?:    .*)?\n)+", "\n", text)
    return paragraphs("" if line.startswith("#") else line for line in text.splitlines())


def header_prose(text):
    """Paragraphs of the comments that describe what a header declares."""
    text = re.sub(r"\\(code|verbatim).*?\\end\1", "", text, flags=re.DOTALL)
    lines, trailing = [], False
    for line in text.splitlines():
        comment = re.search(r"//[/!]?(<?) ?(.*)", line)
        if not comment:
            lines.append("")
            continue
        behind = not line.lstrip().startswith("//")
        if behind or comment[2].startswith("\\") or (trailing and not comment[1]):
            lines.append("")
        lines.append(comment[2])
        trailing = behind or bool(comment[1])
    return (re.sub(r"\\\w+", "", paragraph).strip() for paragraph in paragraphs(lines))


def help_prose(text):
    """Paragraphs and descriptions of options of a help; its examples are code."""
    lines = []
    for line in re.sub(r"^Examples?:\n(?:  .*\n?)+", "", text, flags=re.MULTILINE).splitlines():
        option = re.match(r"  \S.*?  +(\S.*)", line)
        lines += ["", option[1]] if option else ["", line] if line.startswith("Usage: ") else [line]
    return paragraphs(lines)


def sentences(paragraph):
    return [part for part in END.split(plain(paragraph).strip()) if part]


def words(sentence):
    return sum(bool(re.search(r"\w", word)) for word in sentence.split())


def faults(texts):
    """Long and fronted sentences of some paragraphs."""
    every = [sentence for paragraph in texts for sentence in sentences(paragraph)]
    return {"long": [s for s in every if words(s) > MOST_WORDS],
            "fronted": [s for s in every if s.startswith("Of ")]}


def helps(command):
    """(name, text) of the help of the command and of each verb."""
    def text(*arguments):
        return subprocess.run([command, *arguments, "--help"], check=True, capture_output=True, text=True).stdout
    whole = text()
    yield "soms --help", whole
    for line in whole.split("Verbs:\n", 1)[1].split("\n\n", 1)[0].splitlines():
        verb = line.split()[0]
        yield f"soms {verb} --help", text(verb)


def found_in(root, command):
    """By text, what breaks a rule."""
    found = {}
    for page in [root / "README.md", root / "CHANGELOG.md", *sorted(root.glob("docs/*.md"))]:
        found[page.relative_to(root).as_posix()] = faults(page_prose(page.read_text(encoding="utf-8")))
    for header in sorted(root.glob("soms/**/*.h")):
        name = header.relative_to(root).as_posix()
        if not PRIVATE.search(name):
            found[name] = faults(header_prose(header.read_text(encoding="utf-8")))
    for name, text in helps(command) if command else ():
        found[name] = faults(help_prose(text))
    return found


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return {row["text"]: {kind: int(row[kind]) for kind in FIELDS[1:]} for row in csv.DictReader(file)}


def write(path, allowed, found):
    """The lesser of what is allowed and found; a text that was not read keeps its row."""
    lesser = collections.Counter()
    for name, row in allowed.items():
        for kind, count in row.items():
            lesser[name, kind] = min(count, len(found[name][kind])) if name in found else count
    with open(path, "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(FIELDS)
        for name in sorted(allowed):
            counts = [lesser[name, kind] for kind in FIELDS[1:]]
            if any(counts):
                rows.writerow([name, *counts])


def main():
    words_given = sys.argv[1:]
    listed = words_given[words_given.index("--list") + 1:] if "--list" in words_given else []
    places = [word for word in words_given if word not in listed and not word.startswith("--")]
    root, path = pathlib.Path(places[0]), pathlib.Path(__file__).with_name("prose_exceptions.csv")
    allowed, found = read(path), found_in(root, places[1] if len(places) > 1 else "")
    risen = 0
    for name, kinds in found.items():
        for kind, which in kinds.items():
            most = allowed.get(name, {}).get(kind, 0)
            risen += len(which) > most
            if len(which) > most or name in listed:
                print(f"{name}: {len(which)} {kind} sentences, {most} allowed", *which, sep="\n  ")
    if "--write" in words_given:
        write(path, allowed, found)
    total = {kind: sum(len(kinds[kind]) for kinds in found.values()) for kind in FIELDS[1:]}
    fell = sum(len(found[name][kind]) < most for name, row in allowed.items() if name in found for kind, most in row.items())
    if fell:
        print(f"{fell} counts fell: record it by --write")
    print(f"{len(found)} texts, {total['long']} long and {total['fronted']} fronted sentences, {risen} faults")
    return 1 if risen or len(found) < LEAST_TEXTS else 0


if __name__ == "__main__":
    sys.exit(main())
