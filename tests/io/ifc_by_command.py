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


SYSTEM = "#10=IFCPROJECTEDCRS('EPSG:25833',$,$,$,$,$,$);"
CONVERSION = "#11=IFCMAPCONVERSION(#3,#10,311988.0,5996148.,10.,1.,0.,$);"
FOOT = """#31=IFCMEASUREWITHUNIT(IFCLENGTHMEASURE(304.8),#4);
#32=IFCDIMENSIONALEXPONENTS(1,0,0,0,0,0,0);
#33=IFCCONVERSIONBASEDUNIT(#32,.LENGTHUNIT.,'FOOT',#31);
#10=IFCPROJECTEDCRS('EPSG:25833','d','g','DHHN2016','p','z',#33);"""
SETS = """#10=IFCPROPERTYSET('3vB2YO$MX4xv5uCqZZG0aa',$,'ePset_MapConversion',$,(#40,#41,#42,#43,#44,#45));
#40=IFCPROPERTYSINGLEVALUE('Eastings',$,IFCLENGTHMEASURE(311988.),$);
#41=IFCPROPERTYSINGLEVALUE('Northings',$,IFCLENGTHMEASURE(5996148.),$);
#42=IFCPROPERTYSINGLEVALUE('OrthogonalHeight',$,IFCLENGTHMEASURE(10.),$);
#43=IFCPROPERTYSINGLEVALUE('XAxisAbscissa',$,IFCREAL(0.6),$);
#44=IFCPROPERTYSINGLEVALUE('XAxisOrdinate',$,IFCREAL(0.8),$);
#45=IFCPROPERTYSINGLEVALUE('Scale',$,IFCREAL(0.001),$);
#11=IFCPROPERTYSET('3vB2YO$MX4xv5uCqZZG0ab',$,'ePset_ProjectedCRS',$,(#46,#47));
#46=IFCPROPERTYSINGLEVALUE('Name',$,IFCLABEL('EPSG:25833'),$);
#47=IFCPROPERTYSINGLEVALUE('VerticalDatum',$,IFCIDENTIFIER('DHHN92'),$);"""


def forms_faults(run):
    """Other ways to state a place: a map unit, factors of axes, a rigid operation, property sets of IFC 2x3."""
    text = (MODELS / "fedA.ifc").read_text()
    wall = "IFCWALL('0000000000000000000002',$,'A311988',$,$,#14,#18,$"
    forms = {
        "unit": (text.replace(SYSTEM, FOOT).replace("10.,1.,0.,$", "10.,0.6,0.8,0.001"),
                 "DHHN2016", {"abscissa": 0.6, "ordinate": 0.8, "scale": 0.001, "unit": 0.3048}),
        "factors": (text.replace("'IFC4'", "'IFC4X3_ADD2'").replace(
            CONVERSION, "#11=IFCMAPCONVERSIONSCALED(#3,#10,311988.0,5996148.,10.,1.,0.,2.,0.9996,1.0004,1.);"),
                    None, {"scale": 2.0, "factors": [0.9996, 1.0004, 1.0]}),
        "rigid": (text.replace("'IFC4'", "'IFC4X3_ADD2'").replace(
            CONVERSION, "#11=IFCRIGIDOPERATION(#3,#10,IFCLENGTHMEASURE(311988.),IFCLENGTHMEASURE(5996148.),10.);"), None, {}),
        "sets": (text.replace("'IFC4'", "'IFC2X3'").replace(SYSTEM + "\n" + CONVERSION, SETS).replace(wall + ",$", wall),
                 "DHHN92", {"abscissa": 0.6, "ordinate": 0.8, "scale": 0.001}),
        "two": (text.replace(CONVERSION, CONVERSION + "\n#50=IFCMAPCONVERSION(#3,#10,5.,6.,7.,1.,0.,$);"), None, {}),
    }
    for name, (model, datum, more) in forms.items():
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / f"{name}.ifc"
            path.write_text(model)
            answer = json.loads(run("info", path, "--json", "--no-trees").stdout)
        wanted = {"crs": "EPSG:25833", "vertical_datum": datum, "map_conversion": {**conversion_of(311988.0), **more}}
        if answer["georeference"] != wanted:
            yield f"{name}: {answer['georeference']}, not {wanted}"
        said = any("further map conversions, which differ from the first, not read: 1" in note for note in answer["notes"])
        if said != (name == "two"):
            yield f"{name}: {answer['notes']}"


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
    faults += forms_faults(run)
    print("\n".join(faults) or "holes are no bodies, and what they take whole is counted")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
