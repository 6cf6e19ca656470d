"""Every value type that soms.h shows can be compared and printed (docs/decisions/0036).

A struct or enumeration in a public header of the facade has its `<<` in the print.h of its room, or
its fields or words listed beside it, and a struct says what equality is. What is left out, and why, stands in NOT_VALUES.
"""
import pathlib
import re
import sys

NOT_VALUES = {
    "Parallel": "how to run a call: a stop token and a function",
    "ContactBodies": "how to look at bodies: functions",
    "ClashOptions": "which pairs are wanted is a function",
    "MeshPart": "what a function looks at, by addresses",
}


def faults(root):
    facade = (root / "soms/soms.h").read_text(encoding="utf-8")
    seen = 0
    for path, room in re.findall(r'^#include "(soms/(\w+)/[^"]+)"', facade, re.MULTILINE):
        printer = root / "soms" / room / "print.h"
        printer = printer.read_text(encoding="utf-8") if printer.exists() else ""
        text = (root / path).read_text(encoding="utf-8")
        for kind, name, body in re.findall(
                r"^(struct|enum class) (\w+)(?: : [\w:]+)? \{(\n.*?^|[^\n]*)\};$", text,
                re.MULTILINE | re.DOTALL):
            seen += 1
            if name in NOT_VALUES:
                continue
            if not re.search(rf"operator<<\(std::ostream& out, (const )?{name}(?:<[\w, ]+>)?&? \w+\)|Fields<{name}>|kWords<{name}>"
                             rf"|kBatchName = \"{name}\"",
                             printer + text):
                yield f"{path}: {name} has no operator<<, in soms/{room}/print.h or beside it"
            if kind == "struct" and "operator==" not in body and "operator<=>" not in body:
                yield f"{path}: {name} has no operator=="
    if seen < 30:
        yield f"only {seen} types were found: has the form of headers changed?"


def main():
    found = list(faults(pathlib.Path(sys.argv[1])))
    for line in found:
        print(line)
    print(f"{len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
