"""The drawings of words in docs/ are what tools/draw_terms.py draws, and say what soms answers.

usage: drawings_test.py ROOT COMMAND
"""
import json
import pathlib
import subprocess
import sys
import tempfile

ROUNDING = 4 * 2.0 ** -51  # of points whose largest coordinate is less than 4: 4 units in the last place


def off(triangles):
    corners = [" ".join(repr(float(x)) for x in p) for t in triangles for p in t]
    faces = [f"3 {3 * k} {3 * k + 1} {3 * k + 2}" for k in range(len(triangles))]
    return "\n".join(["OFF", f"{len(corners)} {len(faces)} 0", *corners, *faces, ""])


def answer(command, folder, verb, a, b, *options):
    """What a verb of soms says of two lists of triangles."""
    for name, triangles in (("a.off", a), ("b.off", b)):
        (folder / name).write_text(off(triangles), encoding="utf-8")
    return json.loads(subprocess.run(
        [command, verb, folder / "a.off", folder / "b.off", "--json", *(options or ["--verify"])],
        check=True, capture_output=True, text=True).stdout)


def faults(root, command, folder):
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(root / "tools"))
    import draw_motion
    import draw_terms
    pages = "".join(page.read_text(encoding="utf-8") for page in sorted((root / "docs").glob("*.md")))
    committed = root / "docs/pictures/terms"
    for name, draw in draw_terms.DRAWINGS.items():
        if (committed / f"{name}.svg").read_text(encoding="utf-8") != draw():
            yield f"{name}.svg is not what tools/draw_terms.py draws"
        if f"](pictures/terms/{name}.svg)" not in pages:
            yield f"no page of docs/ shows {name}.svg"
    extra = {f.stem for f in committed.iterdir()} - set(draw_terms.DRAWINGS)
    if extra:
        yield f"drawings that nothing draws: {sorted(extra)}"
    for name, scenes in draw_terms.SCENES.items():
        for title, a, b, overlaps in scenes:
            said = answer(command, folder, "overlap", a, b)
            if said["any"] != overlaps or not said["verified"]:
                yield f"{name}, {title}: drawn as {overlaps}, soms says {said}"
            if said["hash"] != draw_terms.fnv(draw_terms.bytes_of(said["pairs"])):
                yield f"{name}, {title}: soms hashes otherwise: {said}"
    said = answer(command, folder, "motion", *draw_motion.scene(), "--from", "0 0 0", "--to", draw_motion.MOTION["end"])
    if said["verdict"] != "contact" or abs(said["lower"] - draw_motion.MOTION["t"]) > draw_motion.MOTION["digits"]:
        yield f"motion: drawn with {draw_motion.MOTION}, soms says {said}"
    for title, a, b, distance, ends in draw_terms.NEAREST:
        said = answer(command, folder, "distance", a, b)
        if [said["lower"], said["upper"]] != [distance, distance] or not said["verified"]:
            yield f"{title}: drawn with distance {distance}, soms says {said}"
        if ends and any(not abs(x - y) <= ROUNDING for p, q in zip(ends, (said["point_a"], said["point_b"])) for x, y in zip(p, q)):
            yield f"{title}: drawn between {ends}, soms says {said}"


def main():
    root, command = pathlib.Path(sys.argv[1]), sys.argv[2]
    with tempfile.TemporaryDirectory() as place:
        found = list(faults(root, command, pathlib.Path(place)))
    print(*found, f"{len(found)} faults", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
