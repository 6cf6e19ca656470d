"""No two classes of one name in one namespace: each would get the other's inline functions."""
import collections
import pathlib
import re
import sys

NAMESPACE = re.compile(r"\s*(?:inline )?namespace ([\w:]*)\s*\{")
CLASS = re.compile(r"(?:template <.*> ?)?(?:class|struct|enum class|enum) (\w+)(?: final)?(?: *:[^:;]*)?\s*\{")


def classes(path):
    """Full names of the classes that a file defines outside of other classes and of nameless namespaces."""
    depth, open_namespaces = 0, []
    for line in path.read_text().splitlines():
        code = line.split("//")[0]
        named = [name for _, name in open_namespaces]
        if found := NAMESPACE.match(code):
            open_namespaces.append((depth, found[1]))
        elif (found := CLASS.match(code)) and depth == len(named) and named and "" not in named:
            yield "::".join([*named, found[1]])
        depth += code.count("{") - code.count("}")
        while open_namespaces and depth <= open_namespaces[-1][0]:
            open_namespaces.pop()


def main():
    root = pathlib.Path(sys.argv[1])
    places = collections.defaultdict(set)
    for folder in ("soms", "apps", "thesis", "bench"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                for name in classes(path):
                    places[name].add(str(path.relative_to(root)))
    faults = [f"{name}: {', '.join(sorted(files))}" for name, files in places.items() if len(files) > 1]
    print("\n".join(faults))
    print(f"{len(places)} classes, {len(faults)} faults")
    return 1 if faults or len(places) < 300 else 0


sys.exit(main())
