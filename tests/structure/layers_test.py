"""Every include in soms/ points to its own layer or a lower one, and to no program or test."""
import pathlib
import re
import sys

MAY_INCLUDE = {
    "base": {"base"},
    "geometry": {"base", "geometry"},
    "tree": {"base", "geometry", "tree"},
    "query": {"base", "geometry", "tree", "query"},
    "scene": {"base", "geometry", "tree", "query", "scene"},
    "io": {"base", "geometry", "io"},
    "generate": {"base", "geometry", "generate"},
}
FOREIGN = re.compile(r"^(GL/|GLFW|epoxy|imgui|CLI/|nlohmann/)")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def breaches(root):
    for file in sorted((root / "soms").rglob("*")):
        if file.suffix not in {".h", ".cpp"} or file == root / "soms" / "soms.h":
            continue
        room = file.relative_to(root / "soms").parts[0]
        inside = str(file.relative_to(root))
        for kind, name in INCLUDE.findall(file.read_text(encoding="utf-8")):
            parts = name.split("/")
            if name == "soms/soms.h":
                yield f"{inside} includes the facade"
            elif parts[0] == "soms" and parts[1] not in MAY_INCLUDE[room]:
                yield f"{inside} includes {name}: {room} may not see {parts[1]}"
            elif parts[0] in {"apps", "tests", "bench", "reproduce"} or FOREIGN.match(name):
                yield f"{inside} includes {name}"
            elif kind == '"' and parts[0] != "soms":
                yield f"{inside} includes {name} without its folder"
            elif "/tree/rule/" in f"/{inside}" and name.startswith("soms/tree/layout"):
                yield f"{inside} includes {name}: a rule may not see a layout"
            elif "detail" in parts[:-1] and parts[1] != room:
                yield f"{inside} includes {name}: private to {parts[1]}"
            if file.suffix == ".h" and re.match(r"^(hwy/|tbb/|fmt/|assimp/|pugixml)", name):
                yield f"{inside} shows {name} in a header"


def main():
    root = pathlib.Path(sys.argv[1])
    files = [f for f in (root / "soms").rglob("*") if f.suffix in {".h", ".cpp"}]
    found = list(breaches(root))
    for line in found:
        print(line)
    print(f"{len(files)} files, {len(found)} breaches")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
