"""Every include in soms/ points to its own layer or a lower one, and to no program or test.

Programs see the library, apps/support and (the command) apps/report, never each other; the viewer's rooms see lower ones only.
"""
import pathlib
import re
import sys

MAY_INCLUDE = {
    "base": {"base"},
    "geometry": {"base", "geometry"},
    "tree": {"base", "geometry", "tree"},
    "query": {"base", "geometry", "tree", "query"},
    "thesis": {"base", "geometry", "tree", "query", "thesis"},
    "scene": {"base", "geometry", "tree", "query", "scene"},
    "clash": {"base", "geometry", "tree", "query", "scene", "clash"},
    "kinematics": {"base", "geometry", "kinematics"},
    "robot": {"base", "geometry", "kinematics", "tree", "query", "scene", "clash", "robot"},
    "io": {"base", "geometry", "kinematics", "io"},
    "generate": {"base", "geometry", "generate"},
    "adapt": {"base", "geometry", "adapt"},
}
# Private headers that one other room may see, and why: no user has a need of them.
LENT = {
    ("query", "soms/geometry/detail/pair_distance.h"): "what a traversal knows of a candidate pair",
    ("query", "soms/geometry/detail/exact_distance.h"): "the brute-force twin decides in whole numbers alone",
    ("query", "soms/geometry/detail/nearest_points.h"): "as exact_distance.h",
    ("query", "soms/geometry/detail/point_to_triangle.h"): "what a traversal knows of a candidate triangle",
    ("query", "soms/geometry/detail/exact_point.h"): "as exact_distance.h",
    ("query", "soms/geometry/detail/exact_ray.h"): "where a ray meets a candidate triangle",
    ("query", "soms/geometry/detail/ray_plane.h"): "the same in floating point",
    ("query", "soms/geometry/detail/odd_edges.h"): "a body keeps its odd edges, to be looked at again at another pose",
    ("query", "soms/geometry/detail/connected_parts.h"): "a body keeps its connected parts, to be queried at any pose",
    ("query", "soms/geometry/detail/joined.h"): "as connected_parts.h",
    ("query", "soms/geometry/detail/plane_cells.h"): "bodies that touch are distinguished by the cells of their triangles",
    ("query", "soms/geometry/detail/predicates.h"): "tests of a ray say whether a filter sufficed",
    ("query", "soms/geometry/detail/double_double.h"): "angles near an edge need twice the digits",
    ("query", "soms/geometry/detail/power_of_two.h"): "rays are scaled as often as in geometry",
    ("scene", "soms/geometry/detail/point_to_triangle.h"): "which of many bodies is nearest is decided exactly",
    ("scene", "soms/geometry/detail/exact_ray.h"): "as point_to_triangle.h",
    ("scene", "soms/geometry/detail/exact_point.h"): "as exact_distance.h",
    ("scene", "soms/query/detail/engine/batch.h"): "batches are shared out alike",
    ("scene", "soms/query/detail/kernels/target.h"): "kernels of a sweep are compiled as those of queries are",
    ("scene", "soms/query/detail/moved_triangle.h"): "triangles of nearest and of touching bodies are where queries see them",
    ("scene", "soms/query/detail/ray/ray_line.h"): "so are rays and segments",
    ("clash", "soms/geometry/detail/part_groups.h"): "odd edges of parts are known before parts are joined",
    ("clash", "soms/query/detail/closed_surface.h"): "connected parts are found while closedness is checked",
    ("clash", "soms/query/detail/moved_triangle.h"): "triangles of parts are where queries see them",
    ("clash", "soms/scene/detail/contact_place.h"): "a clash has its place where a contact has it",
    ("clash", "soms/scene/detail/widened.h"): "what is near is found by the same larger boxes",
    ("robot", "soms/query/detail/closed_surface.h"): "connected parts have boxes where a state moves them",
    ("robot", "soms/query/detail/moved_triangle.h"): "triangles of links are where queries see them",
    ("robot", "soms/scene/detail/moved_bounds.h"): "boxes of links hold the moved vertices, as those of a scene do",
    ("thesis", "soms/query/detail/collector.h"): "modes and limits mean the same by every traversal",
    ("thesis", "soms/query/detail/engine/limit.h"): "so do deadlines",
    ("thesis", "soms/query/detail/engine/batch.h"): "poses of batches are checked alike",
    ("thesis", "soms/query/detail/overlap_traversal.h"): "the default traversal is watched as it is",
    ("thesis", "soms/query/detail/engine/pair_frame.h"): "likewise",
    ("thesis", "soms/query/detail/engine/block_source.h"): "likewise",
}
PROGRAMS = {"cli": {"cli"}, "support": {"cli", "support"}, "report": {"report"},
            "soms": {"cli", "soms", "support", "report"}, "reproduce": {"cli", "reproduce", "support"},
            "view": {"cli", "view", "support"}, "import": {"import"}}
PARSES = "apps/cli/cli11.cpp"  # alone sees CLI11
ANYBODY = {"apps/support/look.h"}  # colors alone, which all pages and pictures share
VIEW_ROOMS = ["drawing", "scene", "control", "window", "verbs"]  # the lowest first
FOREIGN = re.compile(r"^(GL/|GLFW|epoxy|imgui|CLI/)")
ADAPTED = re.compile(r"^(Eigen|glm)/")  # for the headers of adapt alone
READERS = re.compile(r"^nlohmann/")  # for the sources of io alone
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
            elif parts[0] in {"apps", "tests", "bench", "reproduce"} or FOREIGN.match(name) or (
                    READERS.match(name) and room != "io") or (
                    ADAPTED.match(name) and room != "adapt"):
                yield f"{inside} includes {name}"
            elif kind == '"' and parts[0] != "soms":
                yield f"{inside} includes {name} without its folder"
            elif "/tree/rule/" in f"/{inside}" and name.startswith("soms/tree/layout"):
                yield f"{inside} includes {name}: a rule may not see a layout"
            elif "detail" in parts[:-1] and parts[1] != room and (room, name) not in LENT:
                yield f"{inside} includes {name}: private to {parts[1]}"
            private = "detail" in file.relative_to(root).parts
            if file.suffix == ".h" and not private and re.match(r"^(hwy/|tbb/|fmt/|assimp/|pugixml|nlohmann/)", name):
                yield f"{inside} shows {name} in a header"


def program_breaches(root):
    for file in sorted((root / "apps").rglob("*")):
        if file.suffix not in {".h", ".cpp"}:
            continue
        inside = file.relative_to(root)
        program, room = inside.parts[1], inside.parts[2]
        for _, name in INCLUDE.findall(file.read_text(encoding="utf-8")):
            parts = name.split("/")
            if parts[0] in {"tests", "bench"} or "detail" in parts[:-1] and parts[0] == "soms":
                yield f"{inside} includes {name}"
            elif program != "view" and re.match(r"^(GL/|GLFW|epoxy|EGL|imgui|glm/)", name):
                yield f"{inside} includes {name}"
            if name.startswith("CLI/") and str(inside) != PARSES:
                yield f"{inside} includes {name}, which {PARSES} alone sees"
            if str(inside) in ANYBODY and name.startswith(("soms/", "apps/")):
                yield f"{inside} includes {name}, and everybody sees it"
            if parts[0] != "apps" or name in ANYBODY:
                continue
            if parts[1] not in PROGRAMS[program]:
                yield f"{inside} includes {name}: {program} may not see {parts[1]}"
            elif program == "view" and room == "drawing" and parts[1] == "support":
                yield f"{inside} includes {name}: drawing knows nothing of models"
            elif parts[1] == "view" and room in VIEW_ROOMS and parts[2] in VIEW_ROOMS:
                if VIEW_ROOMS.index(parts[2]) > VIEW_ROOMS.index(room):
                    yield f"{inside} includes {name}: {room} may not see {parts[2]}"


def main():
    root = pathlib.Path(sys.argv[1])
    files = [f for folder in ("soms", "apps") for f in (root / folder).rglob("*")
             if f.suffix in {".h", ".cpp"}]
    found = [*breaches(root), *program_breaches(root)]
    for line in found:
        print(line)
    print(f"{len(files)} files, {len(found)} breaches")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
