"""Links of the repository's pages lead somewhere, also where only the pages are installed, pictures say
in words what they show, and the index docs/README.md lists every page of docs/.

usage: links_test.py ROOT
"""
import pathlib
import re
import sys

LINK = re.compile(r"(!?)\[((?:[^\[\]]|!\[[^\]]*\]\([^)]*\))*)\]\(([^)\s]+)\)")
INSTALLED = {"README.md", "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE"}  # and docs/
LEAST_WORDS = 3  # of what is said of a picture


def prose(text):
    """The text without what is shown as code."""
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE))


def anchors(page):
    """Names that a link may give to the headings of a page."""
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"),
                  flags=re.DOTALL | re.MULTILINE)
    found = set()
    for heading in re.findall(r"^#+ (.+)$", text, re.MULTILINE):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        found.add(re.sub(r"[^\w\- ]", "", words).replace(" ", "-"))
    return found


def is_installed(root, file):
    """True for what cmake/install.cmake puts into share/doc/soms."""
    return file.parent == root and file.name in INSTALLED or root / "docs" in [file, *file.parents]


def faults(root, page):
    for picture, words, target in LINK.findall(prose(page.read_text(encoding="utf-8"))):
        name = f"{page.relative_to(root)}: {target}"
        if picture and len(words.split()) < LEAST_WORDS:
            yield f"{name} is shown without words"
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = (page.parent / path).resolve() if path else page
        if not file.exists() or root not in file.parents:
            yield f"{name} is not there"
        elif is_installed(root, page) and not is_installed(root, file):
            yield f"{name} is not installed beside the page: name the file instead"
        elif anchor and file.suffix == ".md" and anchor not in anchors(file):
            yield f"{name}: no such heading"


def unlisted(root):
    """Pages of docs/ that its index does not link to."""
    index = root / "docs/README.md"
    listed = {target.partition("#")[0] for _, _, target in LINK.findall(prose(index.read_text(encoding="utf-8")))}
    for page in sorted(root.glob("docs/*.md")):
        if page != index and page.name not in listed:
            yield f"docs/README.md does not list {page.name}"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    pages = [*root.glob("*.md"), *(p for folder in ("docs", "bench", "tests", "apps")
                                   for p in root.glob(f"{folder}/**/*.md")
                                   if "node_modules" not in p.parts)]
    found = [fault for page in sorted(pages) for fault in faults(root, page)]
    found += unlisted(root)
    print(*found, f"{len(pages)} pages, {len(found)} faults", sep="\n")
    return 1 if found or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
