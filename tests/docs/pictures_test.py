"""Every picture of docs/pictures is shown by a page, made by tools/make_pictures.sh, and small.

usage: pictures_test.py ROOT
"""
import pathlib
import re
import subprocess
import sys

MOST = 450_000  # bytes, as in tools/make_pictures.sh


def faults(root):
    folder = root / "docs/pictures"
    named = subprocess.run(["sh", root / "tools/make_pictures.sh", "--names"], check=True, capture_output=True,
                           text=True).stdout.split()
    made = {name if "." in name else f"{name}.png" for name in named if name != "terms"}
    files = {f.name: f for f in folder.iterdir() if f.is_file()}
    pages = [root / "README.md", *sorted((root / "docs").glob("*.md"))]
    shown = set()
    for page in pages:
        shown |= set(re.findall(r"pictures/([A-Za-z0-9_]+\.(?:png|svg))", page.read_text(encoding="utf-8")))
    for name, file in sorted(files.items()):
        if name not in shown:
            yield f"{name}: no page shows it"
        if name not in made:
            yield f"{name}: tools/make_pictures.sh does not make it"
        if file.stat().st_size > MOST:
            yield f"{name}: {file.stat().st_size} bytes, more than {MOST}"
    for name in sorted(made - set(files)):
        yield f"{name}: tools/make_pictures.sh makes it, and it is not there"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found = list(faults(pathlib.Path(sys.argv[1])))
    for fault in found:
        print(fault)
    print(f"{len(found)} faults")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
