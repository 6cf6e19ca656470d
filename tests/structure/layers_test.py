"""Every include in soms/ points to its own layer or a lower one, and to no program or test.

What stands on the library (programs, the thesis' experiments, bindings) is in rooms, and each room sees only the rooms that ABOVE
names; the viewer's rooms see lower ones only.
"""
import pathlib
import re
import sys

MAY_INCLUDE = {
    "base": {"base"},
    "describe": {"base", "describe"},
    "geometry": {"base", "describe", "geometry"},
    "tree": {"base", "describe", "geometry", "tree"},
    "query": {"base", "describe", "geometry", "tree", "query"},
    "motion": {"base", "describe", "geometry", "tree", "query", "motion"},
    "thesis": {"base", "describe", "geometry", "tree", "query", "thesis"},
    "scene": {"base", "describe", "geometry", "tree", "query", "motion", "scene"},
    "clash": {"base", "describe", "geometry", "tree", "query", "motion", "scene", "clash"},
    "kinematics": {"base", "describe", "geometry", "kinematics"},
    "robot": {"base", "describe", "geometry", "kinematics", "tree", "query", "motion", "scene", "clash", "robot"},
    "io": {"base", "describe", "geometry", "kinematics", "io"},
    "store": {"base", "describe", "geometry", "tree", "io", "store"},
    "tiles": {"base", "describe", "geometry", "tree", "query", "motion", "scene", "io", "store", "tiles"},
    "generate": {"base", "describe", "geometry", "generate"},
    "adapt": {"base", "describe", "geometry", "adapt"},
}
# Private headers that one other room may see, and why: no user has a need of them.
LENT = {
    ("tree", "soms/geometry/detail/counts.h"): "files say how large a mesh is before there is one",
    ("io", "soms/geometry/detail/counts.h"): "likewise",
    ("tiles", "soms/geometry/detail/counts.h"): "likewise",
    ("query", "soms/geometry/detail/pair_distance.h"): "what a traversal knows of a candidate pair",
    ("query", "soms/geometry/detail/exact/exact_distance.h"): "the brute-force twin decides in whole numbers alone",
    ("query", "soms/geometry/detail/nearest_points.h"): "as exact_distance.h",
    ("query", "soms/geometry/detail/point_to_triangle.h"): "what a traversal knows of a candidate triangle",
    ("query", "soms/geometry/detail/exact/exact_point.h"): "as exact_distance.h",
    ("query", "soms/geometry/detail/exact/exact_ray.h"): "where a ray meets a candidate triangle",
    ("query", "soms/geometry/detail/ray_plane.h"): "the same in floating point",
    ("query", "soms/geometry/detail/parts/odd_edges.h"): "a body keeps its odd edges, to be looked at again at another pose",
    ("query", "soms/geometry/detail/parts/connected_parts.h"): "a body keeps its connected parts, to be queried at any pose",
    ("query", "soms/geometry/detail/parts/joined.h"): "as connected_parts.h",
    ("query", "soms/geometry/detail/parts/plane_cells.h"): "bodies that touch are distinguished by the cells of their triangles",
    ("query", "soms/geometry/detail/exact/predicates.h"): "tests of a ray say whether a filter sufficed",
    ("query", "soms/geometry/detail/exact/double_double.h"): "angles near an edge need twice the digits",
    ("query", "soms/geometry/detail/exact/power_of_two.h"): "rays are scaled as often as in geometry",
    ("query", "soms/tree/layout/detail/compact_node.h"): "a compact tree is unpacked block by block",
    ("query", "soms/tree/layout/detail/ground_plan.h"): "as wide_tree.h",
    ("query", "soms/tree/layout/detail/pages.h"): "blocks that are unpacked lie as those of the layout do",
    ("query", "soms/tree/layout/detail/wide_tree.h"): "queries traverse the layout, which is made for them",
    ("motion", "soms/query/detail/kernels/lanes_double.h"): "doubles side by side, as kernels of queries have them",
    ("motion", "soms/query/detail/kernels/target.h"): "likewise",
    ("motion", "soms/geometry/detail/exact/exact_distance.h"): "straight motions are decided in whole numbers",
    ("motion", "soms/geometry/detail/exact/double_double3.h"): "a filter before whole numbers",
    ("motion", "soms/geometry/detail/exact/exact_ray.h"): "so they are by rays",
    ("motion", "soms/geometry/detail/exact/grid.h"): "places of all of them are on one grid",
    ("motion", "soms/geometry/detail/exact/integer.h"): "the brute-force twin decides in whole numbers alone",
    ("motion", "soms/geometry/detail/parts/odd.h"): "which are made of doubles",
    ("motion", "soms/geometry/detail/nearest_guess.h"): "where two triangles may be parted is a guess",
    ("motion", "soms/query/detail/check_options.h"): "motions refuse what single poses refuse",
    ("motion", "soms/query/detail/engine/block_source.h"): "the two are traversed together by the same blocks",
    ("motion", "soms/query/detail/engine/limit.h"): "deadlines are looked at as often",
    ("motion", "soms/query/detail/engine/node_id.h"): "nodes are named alike",
    ("motion", "soms/query/detail/engine/pair_frame.h"): "poses are checked alike",
    ("motion", "soms/query/detail/moved_triangle.h"): "triangles of the fixed body are where queries see them",
    ("motion", "soms/query/detail/near/near_query.h"): "as check_options.h",
    ("motion", "soms/query/detail/relative_pose.h"): "moved boxes are bounded alike",
    ("motion", "soms/query/reference/detail/moved_triangles.h"): "as moved_triangle.h",
    ("motion", "soms/tree/layout/detail/wide_tree.h"): "motions traverse the layout, too",
    ("motion", "soms/query/detail/nodes_in_box.h"): "only what is near the way is traversed",
    ("scene", "soms/motion/detail/contact_in_box.h"): "the ways of a step are in boxes",
    ("scene", "soms/motion/detail/moved_bounds.h"): "boxes hold moved vertices",
    ("scene", "soms/motion/detail/quaternion.h"): "a path follows the law of a motion",
    ("scene", "soms/motion/detail/swept_bounds.h"): "which boxes hold",
    ("scene", "soms/motion/detail/widened.h"): "what is near is found by larger boxes",
    ("scene", "soms/geometry/detail/point_to_triangle.h"): "which of many bodies is nearest is decided exactly",
    ("scene", "soms/geometry/detail/exact/exact_ray.h"): "as point_to_triangle.h",
    ("scene", "soms/geometry/detail/exact/exact_point.h"): "as exact_distance.h",
    ("scene", "soms/query/detail/check_options.h"): "a step refuses what its queries refuse",
    ("scene", "soms/query/detail/overlap_run.h"): "a step is many batches, one after the other",
    ("scene", "soms/query/detail/engine/batch.h"): "batches are shared out alike",
    ("scene", "soms/query/detail/kernels/target.h"): "kernels of a sweep are compiled as those of queries are",
    ("scene", "soms/query/detail/moved_triangle.h"): "triangles of nearest and of touching bodies are where queries see them",
    ("scene", "soms/query/detail/ray/ray_line.h"): "so are rays and segments",
    ("clash", "soms/geometry/detail/parts/part_groups.h"): "odd edges of parts are known before parts are joined",
    ("clash", "soms/query/detail/closed_surface.h"): "connected parts are found while closedness is checked",
    ("clash", "soms/query/detail/moved_triangle.h"): "triangles of parts are where queries see them",
    ("clash", "soms/scene/detail/contact_place.h"): "a clash has its place where a contact has it",
    ("clash", "soms/motion/detail/widened.h"): "what is near is found by the same larger boxes",
    ("robot", "soms/query/detail/closed_surface.h"): "connected parts have boxes where a state moves them",
    ("robot", "soms/motion/detail/contact_query.h"): "a way between states is a motion by another law",
    ("robot", "soms/motion/detail/motion_bounds.h"): "bodies leave their chords by as much",
    ("robot", "soms/motion/detail/motion_interval.h"): "velocities are seen from a body that turns",
    ("robot", "soms/motion/detail/motion_law.h"): "that law",
    ("robot", "soms/motion/detail/quaternion.h"): "lengths are measured alike",
    ("robot", "soms/motion/detail/rigid_law.h"): "the unit of rounding, and what underflows",
    ("robot", "soms/query/detail/relative_pose.h"): "the farthest corner of a box",
    ("robot", "soms/query/detail/moved_triangle.h"): "triangles of links are where queries see them",
    ("robot", "soms/motion/detail/moved_bounds.h"): "boxes of links hold the moved vertices, as those of a scene do",
    ("store", "soms/io/detail/file.h"): "tree files are opened as models are",
    ("store", "soms/tree/layout/detail/pages.h"): "arrays of files lie as those of the layout do",
    ("store", "soms/io/detail/output.h"): "and written as they are",
    ("tiles", "soms/geometry/detail/pair_distance.h"): "which of two tiles is nearer is decided exactly",
    ("tiles", "soms/query/detail/check_options.h"): "tiles refuse what single models refuse",
    ("tiles", "soms/query/detail/engine/batch.h"): "poses of batches are checked alike",
    ("tiles", "soms/query/detail/moved_triangle.h"): "triangles of tiles are where queries see them",
    ("tiles", "soms/scene/detail/box_bounds.h"): "tiles are searched by their boxes as bodies of a scene are",
    ("tiles", "soms/scene/detail/box_index.h"): "likewise",
    ("tiles", "soms/motion/detail/moved_bounds.h"): "likewise",
    ("tiles", "soms/scene/detail/search/measures.h"): "and in the same order",
    ("tiles", "soms/tree/file/detail/statements.h"): "what a mesh states decides the bytes of its tiles",
    ("tiles", "soms/store/detail/mapped_file.h"): "numbers of triangles are mapped as tree files are",
    ("tiles", "soms/io/detail/file.h"): "manifests are read as models are",
    ("tiles", "soms/io/detail/output.h"): "and written as they are",
    ("tiles", "soms/io/detail/json_document.h"): "manifests are JSON",
    ("tiles", "soms/io/detail/source.h"): "likewise",
    ("thesis", "soms/query/detail/check_options.h"): "named traversals refuse what the default one refuses",
    ("thesis", "soms/query/detail/collector.h"): "modes and limits mean the same by every traversal",
    ("thesis", "soms/query/detail/engine/limit.h"): "so do deadlines",
    ("thesis", "soms/query/detail/engine/batch.h"): "poses of batches are checked alike",
    ("thesis", "soms/query/detail/overlap_traversal.h"): "the default traversal is watched as it is",
    ("thesis", "soms/query/detail/engine/pair_frame.h"): "likewise",
    ("thesis", "soms/query/detail/engine/block_source.h"): "likewise",
}
# Rooms above the library, by their folders, and the rooms that each may see besides itself. A folder that is not named belongs to
# the nearest one above it.
ABOVE = {
    "apps/draw": set(),
    "apps/output": set(),
    "apps/cli": {"apps/output"},
    "apps/rows": {"apps/output", "apps/cli"},
    "apps/model": {"apps/output", "apps/cli"},
    "apps/store": {"apps/output", "apps/cli", "apps/model"},
    "apps/shards": {"apps/output", "apps/cli", "apps/rows", "apps/model"},
    "apps/world": {"apps/draw", "apps/output", "apps/cli", "apps/model"},
    "apps/report": {"apps/draw"},
    "apps/import": set(),
    "thesis/trips": {"apps/draw", "apps/output"},
    "thesis": {"apps/draw", "thesis/trips"},
    "thesis/program": {"thesis", "thesis/trips", "apps/draw", "apps/output", "apps/cli"},
    "apps/soms": {"apps/draw", "apps/output", "apps/cli", "apps/rows", "apps/model", "apps/store", "apps/shards", "apps/world", "apps/report",
                  "apps/soms/thesis"},
    "apps/soms/thesis": {"apps/soms", "apps/output", "apps/cli", "apps/model", "apps/world", "thesis/trips"},
    "apps/view": {"apps/draw", "apps/output", "apps/cli", "apps/rows", "apps/model", "apps/world"},
    "apps/view/drawing": {"apps/draw", "apps/output"},
    "python": {"apps/report"},
    "web": set(),
}
# Headers that take seconds to compile, and the sources above the library that alone see them (docs/decisions/0086).
ALONE = {"CLI/": {"apps/cli/cli11.cpp"},
         "nlohmann/": {"apps/output/json_text.cpp", "apps/report/script_text.cpp", "thesis/run/manifest.cpp"}}
# What links soms::thesis, above the library: a command without the thesis' wing is built without all of these (0089).
NAMES_TRAVERSALS = ("apps/model/traversal_keys.", "apps/soms/thesis/", "apps/view/", "thesis/")
ANYBODY = {"apps/draw/look.h"}  # colors alone, which all pages and pictures share
VIEW_ROOMS = ["drawing", "scene", "sight", "control", "window", "verbs"]  # the lowest first
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
            elif parts[0] in {"apps", "tests", "bench", "thesis"} or FOREIGN.match(name) or (
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


def room_above(path):
    """The room of a file above the library, or nothing."""
    parts = path.split("/")[:-1]
    names = ("/".join(parts[:count]) for count in range(len(parts), 0, -1))
    return next((name for name in names if name in ABOVE), None)


def view_breach(inside, name):
    """The viewer's rooms, from drawing to verbs, see lower ones only."""
    room, other = inside.split("/")[2], name.split("/")[2]
    return room in VIEW_ROOMS and other in VIEW_ROOMS and VIEW_ROOMS.index(other) > VIEW_ROOMS.index(room)


def breaches_above(root):
    # Private headers that they are built with; lessons draw the nodes that queries traverse.
    lent = {"web": "soms/", "thesis": "soms/thesis/", "apps/view": "soms/tree/layout/detail/wide_tree.h"}
    for file in sorted(f for folder in ("apps", "thesis", "python", "web") for f in (root / folder).rglob("*")):
        if file.suffix not in {".h", ".cpp"}:
            continue
        inside = str(file.relative_to(root))
        room = room_above(inside)
        for _, name in INCLUDE.findall(file.read_text(encoding="utf-8")):
            parts = name.split("/")
            if parts[0] in {"tests", "bench"} or "detail" in parts[:-1] and parts[0] == "soms" and not (
                    name.startswith(lent.get(room, "nothing"))):
                yield f"{inside} includes {name}"
            elif room and not room.startswith("apps/view") and re.match(r"^(GL/|GLFW|epoxy|EGL|imgui|glm/)", name):
                yield f"{inside} includes {name}"
            if name.startswith("soms/thesis/") and not inside.startswith(NAMES_TRAVERSALS):
                yield f"{inside} includes {name}, which is not of soms::soms"
            for costly, sources in ALONE.items():
                if name.startswith(costly) and inside not in sources:
                    yield f"{inside} includes {name}, which only {' and '.join(sorted(sources))} may"
            if inside in ANYBODY and name.startswith(("soms/", "apps/")):
                yield f"{inside} includes {name}, and everybody sees it"
            other = room_above(name)
            if other is None or name in ANYBODY or other == room:
                continue
            both_view = room is not None and room.startswith("apps/view") and other.startswith("apps/view")
            if both_view and view_breach(inside, name) or not both_view and other not in ABOVE.get(room, set()):
                yield f"{inside} includes {name}: {room} may not see {other}"


def main():
    root = pathlib.Path(sys.argv[1])
    files = [f for folder in ("soms", "apps", "thesis", "python", "web") for f in (root / folder).rglob("*")
             if f.suffix in {".h", ".cpp"}]
    found = [*breaches(root), *breaches_above(root)]
    for line in found:
        print(line)
    print(f"{len(files)} files, {len(found)} breaches")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
