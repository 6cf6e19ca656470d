"""CITATION.cff tells what the project tells elsewhere, and follows the Citation File Format 1.2.0.

The version and the name are those of CMakeLists.txt, the license and the authors those of LICENSE. Where
PyYAML is installed, the file is also read with it and its keys are compared with those of the format.
"""
import pathlib
import re
import sys

REQUIRED = {"cff-version", "message", "title", "authors"}
KEYS = REQUIRED | {"abstract", "type", "version", "license", "keywords", "references", "date-released",
                   "repository-code", "url", "doi", "identifiers", "preferred-citation", "contact", "commit"}
OF_REFERENCES = {"type", "title", "authors", "institution", "year", "thesis-type", "url", "doi", "notes",
                 "abstract", "languages", "journal", "volume", "issue", "start", "end"}
OF_PERSONS = {"family-names", "given-names", "name-particle", "name-suffix", "affiliation", "orcid"}


def line(text, key):
    found = re.search(rf"^{key}: *(.+)$", text, re.MULTILINE)
    return found.group(1).strip() if found else f"no {key}"


def fact_faults(root, text):
    project = re.search(r"project\((\w+) VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text("utf-8"))
    license_text = (root / "LICENSE").read_text("utf-8")
    holder = re.search(r"Copyright \(c\) \d+ (.+)", license_text).group(1)
    facts = {"title": project.group(1), "version": project.group(2),
             "license": license_text.split()[0], "cff-version": "1.2.0"}
    for key, value in facts.items():
        if line(text, key) != value:
            yield f"{key} is {line(text, key)}, elsewhere {value}"
    if f"name: {holder}".lower() not in text.lower():
        yield f"the authors are not {holder}"


def author_faults(authors):
    for author in authors:
        if not (set(author) == {"name"} or set(author) <= OF_PERSONS):
            yield f"author {author}"


def form_faults(text):
    import yaml  # noqa: PLC0415
    cff = yaml.safe_load(text)
    yield from (f"no key {key}" for key in sorted(REQUIRED - set(cff)))
    yield from (f"unknown key {key}" for key in sorted(set(cff) - KEYS))
    yield from author_faults(cff["authors"])
    for reference in cff.get("references", []):
        yield from (f"unknown key {key} of a reference" for key in sorted(set(reference) - OF_REFERENCES))
        yield from author_faults(reference["authors"])
        if not isinstance(reference["year"], int):
            yield f"year {reference['year']}"


def main():
    root = pathlib.Path(sys.argv[1])
    text = (root / "CITATION.cff").read_text(encoding="utf-8")
    found = list(fact_faults(root, text))
    try:
        found += form_faults(text)
    except ImportError:
        print("PyYAML is not installed: the form of CITATION.cff was not checked")
    for fault in found:
        print(f"CITATION.cff: {fault}")
    print(f"{len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
