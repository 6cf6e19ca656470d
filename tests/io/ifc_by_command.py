"""What the command says of IFC models with holes and in maps: ifc_by_command.py SOMS WEB_IFC. Skips (77) where
the npm package is not in the build."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

MODELS = pathlib.Path(__file__).resolve().parent.parent / "data" / "ifc"
LOST = ("elements with a shape of which web-ifc makes no triangles, not read: 1, "
        "the first IfcBeam 'B' (0000000000000000000003)")


def conversion_of(eastings):
    return {"eastings": eastings, "northings": 5996148.0, "height": 10.0, "abscissa": 1.0, "ordinate": 0.0,
            "scale": 1.0, "factors": [1.0, 1.0, 1.0], "unit": 1.0}


def georeference_faults(run):
    """R117: one wall in three frames of a map. Each model says where it lies, and differences are warned of."""
    faults = []
    for name, eastings in (("fedA.ifc", 311988.0), ("fedB.ifc", 311998.0), ("fedD.ifc", 311989.0)):
        wanted = {"crs": "EPSG:25833", "vertical_datum": None, "map_conversion": conversion_of(eastings)}
        found = json.loads(run("info", MODELS / name, "--json", "--no-trees").stdout)["georeference"]
        line = f"georeference EPSG:25833; origin at east {eastings:.0f}, north 5996148, height 10"
        if found != wanted or line not in run("info", MODELS / name, "--no-trees").stdout:
            faults.append(f"{name}: {found}, not {wanted}, or no line: {line}")
    with tempfile.TemporaryDirectory() as folder:
        converted = [pathlib.Path(folder) / "a.glb", pathlib.Path(folder) / "d.glb"]
        for name, glb in zip(("fedA.ifc", "fedD.ifc"), converted):
            run("convert", MODELS / name, glb)
        for a, b in ((MODELS / "fedA.ifc", MODELS / "fedD.ifc"), converted):
            rows = [json.loads(line) for line in run("clash", a, "--against", b, "--json").stdout.splitlines()]
            totals = rows[-1]
            warned = [warning for warning in totals["warnings"] if warning["kind"] == "georeferences_differ"]
            if len(warned) != 1 or "lies 1 m east, 0 m north and 0 m up" not in warned[0]["message"]:
                faults.append(f"{a.name} against {b.name}: {totals['warnings']}")
            if totals.get("georeference", {}).get("map_conversion") != conversion_of(311988.0):
                faults.append(f"{a.name} against {b.name}: {totals.get('georeference')}")
        strict = run("clash", converted[0], "--against", converted[1], "--strict", check=False)
        if strict.returncode != 3 or "311989" not in strict.stderr:
            faults.append(f"--strict: {strict.returncode}, {strict.stderr}")
    return faults


def main():
    soms, package = sys.argv[1:]
    if not (pathlib.Path(package) / "package.json").is_file():
        print("web-ifc is not in the build: tools/install_web_ifc.sh installs it by npm")
        return 77

    def run(*words, check=True):
        environment = {**os.environ, "SOMS_WEB_IFC": package}
        return subprocess.run([soms, *words], env=environment, text=True, capture_output=True, check=check)

    faults = []
    for name in ("opening.ifc", "voiding.ifc"):
        rows = [json.loads(line) for line in run("clash", MODELS / name, "--json").stdout.splitlines()]
        clashes = [row for row in rows if "class" in row]
        if not rows or clashes:
            faults.append(f"{name}: {len(rows)} rows, {len(clashes)} clashes: {clashes}")
    for words in (["info"], ["info", "--json"]):
        text = run(*words, MODELS / "lost_void.ifc").stdout
        if LOST not in text:
            faults.append(f"lost_void.ifc: {' '.join(words)} does not say: {LOST}")
    faults += georeference_faults(run)
    print("\n".join(faults) or "holes are no bodies, and what they take whole is counted")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
