#!/usr/bin/env python3
"""Writes what channels say of answers, from the lists of fields that C++ has (soms/describe/fields.h):
classes in the stub of the Python package, its enumerations, tables and types of the npm package.

    tools/fields.py PROGRAM           writes; PROGRAM is build/release/tests/describe/fields
    tools/fields.py PROGRAM --check   fails if a file is not what would be written
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Members of Python that are no fields.
METHODS = {
    "FirstContactBatch": ["@property\n    def first_blocked(self) -> int | None: ..."],
    "Overlap": ["def hash(self) -> int: ..."],
    "SignedClosest": ["@property\n    def lower(self) -> float: ...",
                      "@property\n    def upper(self) -> float: ...",
                      "@property\n    def signed(self) -> float: ..."],
    "SignedClosestBatch": ["@property\n    def signed(self) -> NDArray[np.float64]: ..."],
    "StepReport": ["@property\n    def touching_movers(self) -> NDArray[np.uint32]: ...", "def hash(self) -> int: ..."],
}
# Structures that are tuples in Python.
TUPLES = {
    "struct SceneBody": "tuple[SceneBodyKind, int]",
    "struct ContactSide": "tuple[SceneBodyKind, int, int | None]",
}
# Answers about many bodies are for C++ and Python.
OF_WEB = ["Cost", "Overlap", "OverlapBatch", "Distance", "Within", "Solid", "Contains", "Closest", "NearTriangles",
          "Winding", "ClosestHit", "AnyHit", "AllHits", "FirstContact"]
# Enumerations that the npm package names; the words of others stand where they are used.
WEB_ENUMS = ("Coverage", "Relation", "Side", "TriangleFeature", "ContactVerdict")
# Functions of the npm package that a worker has no name for.
NOT_OF_WORKER = {"load"}


def read(program):
    lines = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
    rows = [json.loads(line) for line in lines]
    return ({row["enum"]: row for row in rows if "enum" in row},
            {row["answer"]: row for row in rows if "answer" in row})


def flat(answer):
    """The fields as channels have them: a bracket is two."""
    for field in answer["fields"]:
        if field["type"] == "bracket":
            for end, what in (("lower", "least"), ("upper", "most")):
                yield {"name": end, "column": end, "type": "double", "rows": field["rows"],
                       "meaning": f"{field['meaning']} is at {what} this."}
        else:
            yield field


# Python

def python_single(kind):
    first, _, rest = kind.partition(" ")
    if first == "optional":
        return python_single(rest) + " | None"
    if first == "list":
        return python_array(rest)
    if kind in TUPLES:
        return TUPLES[kind]
    if first in ("enum", "struct"):
        return rest.split()[0]
    return {"bool": "bool", "double": "float", "uint32": "int", "uint64": "int", "pair": "tuple[int, int]",
            "point": "NDArray[np.float64]", "box": "NDArray[np.float64]"}[kind]


def python_array(kind):
    first, _, rest = kind.partition(" ")
    if first == "optional":
        return python_array(rest) if rest == "point" else "NDArray[np.int64]"  # NaN, or -1, for none
    if first == "enum":
        return "NDArray[np.uint8]" if rest.endswith(" 1") else "NDArray[np.int32]"
    if first == "struct":
        return "NDArray[np.void]"
    return "NDArray[np." + {"bool": "bool_", "flag": "bool_", "double": "float64", "uint32": "uint32",
                            "uint64": "uint64", "pair": "uint32", "point": "float64"}[kind] + "]"


def python_class(name, properties, methods):
    lines = [f"class {name}:"]
    for field, kind in properties:
        lines += ["    @property", f"    def {field}(self) -> {kind}: ..."]
    return "\n".join(lines + ["    " + method for method in methods]) + "\n"


def python_classes(answers):
    for name, answer in answers.items():
        methods = list(METHODS.get(name, []))
        if "truth" in answer:
            methods.insert(0, "def __bool__(self) -> bool: ...")
        if "size" in answer:
            methods.append("def __len__(self) -> int: ...")
        if "at" in answer:
            methods.append(f"def at(self, entry: int) -> {answer['at']}: ...")
        if "of" in answer:
            kind = next(field["type"] for field in answer["fields"] if field["name"] == answer["of"])
            methods.append(f"def of(self, row: int) -> {python_single(kind)}: ...")
        yield python_class(name, [(f["name"], python_single(f["type"])) for f in flat(answer)], methods)
        if "batch" in answer:
            columns = [(f["column"], batch_column(f["type"], answers)) for f in flat(answer)]
            if "costs" in dict(columns):
                columns.append(("cost", "Cost"))
            yield python_class(answer["batch"], columns, METHODS.get(answer["batch"], []) + [
                "def __len__(self) -> int: ...", f"def at(self, entry: int) -> {name}: ..."])


def batch_column(kind, answers):
    nested = answers.get(kind.removeprefix("struct "), {})
    return nested["batch"] if "batch" in nested else python_array(kind)


def python_enum(enum):
    meaning = "\n".join(textwrap.wrap(f'"""{enum["meaning"]}"""', 96, initial_indent="    ",
                                      subsequent_indent="    ", break_on_hyphens=False))
    names = "".join(f"    {word} = {value}\n" for value, word in enumerate(enum["names"]))
    return f"class {enum['enum']}(_enum.IntEnum):\n{meaning}\n\n{names}"


def python_import(enums, stub):
    """The enumerations that the rest of a stub names."""
    names = ", ".join(name for name in enums if re.search(rf"\b{name}\b", stub)) + ","
    lines = textwrap.wrap(names, 100, initial_indent="    ", subsequent_indent="    ")
    return "from soms._enums import (\n" + "\n".join(lines) + "\n)\n"


# JavaScript

def camel(name):
    return re.sub(r"_(.)", lambda found: found[1].upper(), name)


def web_kind(kind):
    """How a single value is taken out of a column."""
    first, _, rest = kind.partition(" ")
    if first == "optional":
        return {"uint32": "triangle", "pair": "pair", "point": "vector"}[rest]
    return {"bool": "flag", "double": "number", "point": "point", "enum": "name", "uint64": "number"}[first]


def web_table(enums, answers):
    names = {}
    fields = {}
    for name in OF_WEB:
        rows = []
        for field in flat(answers[name]):
            kind = field["type"].removeprefix("list ")
            if kind.startswith("enum "):
                names[camel(field["name"])] = enums[kind.split()[1]]["names"]
            if kind != "struct Cost":
                rows.append(camel(field["name"]) + ("" if field["type"].startswith("list ") else
                                                    ":" + web_kind(field["type"])))
        if name != "Cost":
            fields[name] = " ".join(rows)
    lines = ["// Written by tools/fields.py from the lists of fields in C++.",
             "/** Names of the codes that answers of batches hold. */", "export const NAMES = Object.freeze({"]
    lines += ["  %s: Object.freeze([%s])," % (key, ", ".join(f"'{word}'" for word in words))
              for key, words in names.items()]
    lines += ["});", "", "/** Columns of answers in order, each with what it is in a single answer; their cost is last. */",
              "export const FIELDS = Object.freeze({"]
    lines += [f"  {name}: '{text}'," for name, text in fields.items()]
    return "\n".join(lines + ["});", ""])


def web_single(kind, enums):
    first, _, rest = kind.partition(" ")
    if first == "optional":
        return web_single(rest, enums) + " | null"
    if first == "list":
        return web_array(rest)
    if first == "enum":
        name = rest.split()[0]
        return name if name in WEB_ENUMS else " | ".join(f"'{word}'" for word in enums[name]["names"])
    if first == "struct":
        return rest
    return {"bool": "boolean", "double": "number", "uint32": "number", "uint64": "number",
            "pair": "[number, number]", "point": "Float64Array"}[kind]


def web_array(kind):
    first = kind.partition(" ")[0]
    if kind == "optional point":
        return "Float64Array"
    return {"bool": "Uint8Array", "flag": "Uint8Array", "enum": "Uint8Array", "optional": "Int32Array",
            "double": "Float64Array", "point": "Float64Array", "uint32": "Uint32Array", "uint64": "Uint32Array",
            "pair": "Uint32Array"}[first]


def web_shape(kind, rows):
    wide = {"point": " x 3", "pair": " x 2", "optional pair": " x 2", "optional point": " x 3"}.get(kind, "")
    none = {"optional point": "; NaN for none"}.get(kind, "; -1 for none" if kind.startswith("optional") else "")
    return f"{rows}{wide}{none}"


def web_interface(name, rows):
    lines = [f"export interface {name} {{"]
    for field, kind, meaning in rows:
        if meaning not in ("", "n.") and field not in ("coverage", "cost"):  # whose types say it
            lines.append("  /** " + re.sub(r"\b[a-z]+_\w+", lambda found: camel(found[0]), meaning) + " */")
        lines.append(f"  {field}: {kind};")
    return "\n".join(lines + ["}"])


def web_types(enums, answers):
    for name in WEB_ENUMS:
        words = " | ".join(f"'{word}'" for word in enums[name]["names"])
        yield f"/** {enums[name]['meaning']} */\nexport type {name} = {words};"
    for name in OF_WEB:
        answer = answers[name]
        lists = [f for f in flat(answer) if not (f["type"].startswith("list struct Cost"))]
        yield f"/** {answer['meaning']} */\n" + web_interface(name, [
            (camel(f["name"]), web_single(f["type"], enums),
             (web_shape(f["type"].removeprefix("list "), f["rows"]) + ". " if f["type"].startswith("list ") else "")
             + f["meaning"]) for f in lists])
        if "batch" in answer:
            columns = [(camel(f["name"]), web_array(f["type"]), web_shape(f["type"], "n") + ".")
                       for f in flat(answer) if f["type"] != "struct Cost"]
            columns.append(("cost", "Cost", ""))
            yield f"/** Columns of {name}. */\n" + web_interface(
                answer["batch"], columns)


def worker_queries(types, names):
    """The functions that a worker answers as soms.js does: all but those that make handles."""
    makers = re.search(r"MAKERS = Object.freeze\(\{(.*?)\}\)", names, re.DOTALL)[1]
    functions = set(re.findall(r"^export function (\w+)", types, re.MULTILINE))
    return [f"'{name}'" for name in sorted(functions - set(re.findall(r"(\w+):", makers)) - NOT_OF_WORKER)]


def between(text, begin, end, inside):
    head, rest = text.split(begin, 1)
    return head + begin + inside + end + rest.split(end, 1)[1]


def written(program):
    """What each file is to hold."""
    enums, answers = read(program)
    stub = ROOT / "python/soms/_soms.pyi"
    classes = "\n\n".join(part.rstrip("\n") for part in python_classes(answers))
    text = between(stub.read_text(encoding="utf-8"), "# Answers, written by tools/fields.py.\n",
                   "\n# End of answers.\n", "\n" + classes + "\n")
    begin, end = "# Enumerations, written by tools/fields.py.\n", "# End of enumerations.\n"
    yield stub, between(text, begin, end, python_import(enums, between(text, begin, end, "")))
    words = ROOT / "python/soms/_enums.py"
    line = "import enum as _enum\n"  # a name that `from soms._enums import *` leaves out
    head = words.read_text(encoding="utf-8").split(line, 1)[0] + line
    yield words, head + "".join("\n\n" + python_enum(enum) for enum in enums.values())
    yield ROOT / "web/package/fields.js", web_table(enums, answers)
    types = ROOT / "web/package/soms.d.ts"
    names = ROOT / "web/package/worker_names.js"
    text = names.read_text(encoding="utf-8")
    queries = worker_queries(types.read_text(encoding="utf-8"), text)
    yield names, between(text, "export const QUERIES = Object.freeze([\n", "\n]);", "\n".join(textwrap.wrap(
        ", ".join(queries) + ",", 118, initial_indent="  ", subsequent_indent="  ")))
    of_worker = ROOT / "web/package/worker.d.ts"
    lines = textwrap.wrap(" | ".join(queries), 112)
    yield of_worker, between(of_worker.read_text(encoding="utf-8"), "type QueryName =\n", ";\n", "\n    | ".join(
        ["    " + lines[0].removesuffix(" |")] + [line.strip("| ") for line in lines[1:]]))
    yield types, between(types.read_text(encoding="utf-8"), "// Answers, written by tools/fields.py.\n",
                         "\n// End of answers.\n", "\n".join(web_types(enums, answers)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="prints the lists of fields")
    parser.add_argument("--check", action="store_true", help="write nothing; say what differs")
    options = parser.parse_args()
    stale = 0
    for path, text in written(options.program):
        there = path.read_text(encoding="utf-8") if path.exists() else ""
        if there != text:
            stale += 1
            print(f"{path.relative_to(ROOT)}: " + ("is not what tools/fields.py writes" if options.check else "written"))
            if not options.check:
                path.write_text(text, encoding="utf-8")
    return 1 if options.check and stale else 0


if __name__ == "__main__":
    sys.exit(main())
