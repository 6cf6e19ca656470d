"""BCF archives of `soms clash`: what is in them, and that the schemas of buildingSMART allow it.

The schemas are data of others, at SOMS_DATA/bcf; without them, or without xmllint, the test says so and looks at the rest.
"""
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import uuid
import xml.etree.ElementTree as xml
import zipfile
import zlib

MODELS = pathlib.Path(__file__).resolve().parents[1] / "data/clash"
NAMESPACE = uuid.UUID("6f1d3b52-0a94-4c7e-9d21-58e3c64b701f")
SCHEMAS = {"bcf.version": "version", "project.bcfp": "project", "extensions.xml": "extensions", "markup.bcf": "markup", "viewpoint.bcfv": "visinfo"}
CUBE = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def cubes(parts):
    """An OBJ file of boxes: name, lower corner, upper corner."""
    lines, base = [], 1
    for name, low, high in parts:
        lines += [f"v {(high if k & 1 else low)[0]} {(high if k & 2 else low)[1]} {(high if k & 4 else low)[2]}" for k in range(8)]
        lines.append(f"o {name}")
        lines += ["f " + " ".join(str(base + corner) for corner in face) for face in CUBE]
        base += 8
    return "\n".join(lines) + "\n"


STRUCTURE = [("Slab <1> & \"co\"", (0, 0, 0), (8, 6, 0.4)), ("Wall", (0, 0, 0.4), (0.3, 6, 3)), ("Beam", (2, 0, 2.5), (2.4, 6, 3)), ("Far", (50, 0, 0), (51, 1, 1))]
SERVICES = [("Duct", (1, 2, 2.4), (4, 2.5, 2.8)), ("Pipe", (5, 3, -1), (5.2, 3.2, 2)), ("Conduit", (6, 4, 0.1), (7, 4.1, 0.2))]


def run(soms, *words, **more):
    return subprocess.run([soms, *map(str, words)], check=True, capture_output=True, env={**os.environ, "SOURCE_DATE_EPOCH": "1769860800", **more})


def pixels(png):
    """Rows of red, green, blue of a PNG as soms writes it: eight bits, one filter of the row above."""
    if png[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError("no PNG")
    at, data, size = 8, b"", None
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + length]
        if zlib.crc32(kind + body) != struct.unpack(">I", png[at + 8 + length:at + 12 + length])[0]:
            raise ValueError(f"checksum of {kind}")
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
        elif kind == b"IDAT":
            data += body
        at += 12 + length
    raw, rows, above = zlib.decompress(data), [], bytes(3 * size[0])
    for y in range(size[1]):
        line = raw[y * (3 * size[0] + 1):(y + 1) * (3 * size[0] + 1)]
        if line[0] != 2:
            raise ValueError(f"filter {line[0]}")
        above = bytes((byte + up) & 255 for byte, up in zip(line[1:], above))
        rows.append([tuple(above[k:k + 3]) for k in range(0, len(above), 3)])
    return rows


def count_colors(rows):
    """Pixels that are blue, sand (as it is, or through blue glass) and red, in whatever light."""
    flat = [pixel for row in rows for pixel in row]
    return [sum(b > r + 40 and b > g + 15 for r, g, b in flat), sum(r > b + 25 and g > b + 10 and r < g + 60 or r > b - 35 and g > r + 8 and 60 < r < 190 for r, g, b in flat),
            sum(r > 180 and g < 95 and b < 80 for r, g, b in flat)]


def invalid(schemas, version, archive, folder):
    """Files of an archive that their schema does not allow."""
    groups = {}
    with zipfile.ZipFile(archive) as opened:
        for name in opened.namelist():
            last = name.split("/")[-1]
            if last in SCHEMAS:
                path = folder / version / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(opened.read(name))
                groups.setdefault(SCHEMAS[last], []).append(path)
            elif last != "snapshot.png":
                yield f"{version}: {name} is of no known kind"
    if len(groups) != (5 if version == "3.0" else 4):
        yield f"{version}: files of {sorted(groups)}"
    for schema, files in groups.items():
        done = subprocess.run(["xmllint", "--noout", "--nonet", "--schema", schemas / version / f"{schema}.xsd", *files], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            yield f"{version}, {schema}: {done.stderr[:500]}"


def topics_of(archive):
    """Of each topic: its markup, its viewpoint or nothing, its picture or nothing."""
    with zipfile.ZipFile(archive) as opened:
        if opened.testzip() is not None:
            raise ValueError("a checksum is wrong")
        names = set(opened.namelist())
        for name in opened.namelist():
            if name.endswith("/markup.bcf"):
                folder = name[:-len("markup.bcf")]
                view = xml.fromstring(opened.read(folder + "viewpoint.bcfv")) if folder + "viewpoint.bcfv" in names else None
                picture = opened.read(folder + "snapshot.png") if folder + "snapshot.png" in names else None
                yield folder[:-1], xml.fromstring(opened.read(name)), view, picture


def numbers(node):
    return [float(node.find(axis).text) for axis in "XYZ"]


def content_faults(rows, archive, version):
    """Each row of the list is a topic, in order, that says what the row says."""
    topics = list(topics_of(archive))
    if len(topics) != len(rows):
        yield f"{version}: {len(topics)} topics of {len(rows)} rows"
    for (guid, markup, view, picture), row in zip(topics, rows):
        topic = markup.find("Topic")
        if guid != str(uuid.uuid5(NAMESPACE, "topic " + row["key"])) or topic.get("Guid") != guid:
            yield f"{version}: {guid} is not the GUID of {row['key']}"
        said = topic.find("Title").text + topic.find("Description").text
        for word in (row["class"], row["a"]["part"], row["b"]["part"], row["key"], str(row["triangle_pairs"])):
            if word not in said:
                yield f"{version}: {word} is not said: {said}"
        status = {"new": "Open", "active": "Active", "resolved": "Closed"}.get(row.get("status"), "Open")
        if topic.get("TopicStatus") != status or topic.get("TopicType") != "Clash":
            yield f"{version}: {topic.attrib} of status {row.get('status')}"
        if topic.find("CreationDate").text != "2026-01-31T12:00:00Z":
            yield f"{version}: created {topic.find('CreationDate').text}"
        labels = [e.text for e in (topic.findall("Labels/Label") if version == "3.0" else topic.findall("Labels"))]
        if labels[:1] != [row["class"]]:
            yield f"{version}: labels {labels}"
        camera = view.find("PerspectiveCamera")
        eye, sight = numbers(camera.find("CameraViewPoint")), numbers(camera.find("CameraDirection"))
        away = [p - e for p, e in zip(row["place"], eye)]
        along = sum(a * b for a, b in zip(away, sight))
        aside = max(0.0, sum(a * a for a in away) - along * along) ** 0.5
        if along <= 0 or aside > 0.4143 * along:
            yield f"{version}: the place of {row['key']} is out of the camera's sight"
        planes = [(numbers(p.find("Location")), numbers(p.find("Direction"))) for p in view.iter("ClippingPlane")]
        if len(planes) != 6 or any(sum((p - q) * d for p, q, d in zip(row["place"], at, out)) > 0 for at, out in planes):
            yield f"{version}: planes cut away the place of {row['key']}"
        colors = [e.get("Color") for e in view.iter("Color")]
        if colors != ["0068B3", "D3B778"]:
            yield f"{version}: colors {colors}"
        picture = pixels(picture)
        found = count_colors(picture)
        if (len(picture), len(picture[0])) != (360, 480) or min(found[:2]) < 300 or found[2] < 20:
            yield f"{version}: {row['key']} has pixels {found}"


def small_faults(soms, folder, schemas):
    (folder / "structure.obj").write_text(cubes(STRUCTURE))
    (folder / "services.obj").write_text(cubes(SERVICES))
    base = ["clash", folder / "structure.obj", "--against", folder / "services.obj", "-o", folder / "list.json"]
    for version in ("2.1", "3.0"):
        archive = folder / f"clashes-{version}.bcfzip"
        run(soms, *base, "-o", archive, "--bcf-version", version)
        rows = json.loads((folder / "list.json").read_text())["rows"]
        if len(rows) != 3 or {row["class"] for row in rows} != {"crossing", "inside"}:
            yield f"rows {[row['class'] for row in rows]}"
        yield from content_faults(rows, archive, version)
        if schemas:
            yield from invalid(schemas, version, archive, folder)
        again = folder / "again.bcfzip"
        run(soms, *base, "-o", again, "--bcf-version", version, "--threads", "1")
        if again.read_bytes() != archive.read_bytes():
            yield f"{version}: a second run gives other bytes"
    default = folder / "default.bcf"
    run(soms, *base, "-o", default)
    if default.read_bytes() != (folder / "clashes-2.1.bcfzip").read_bytes():
        yield "the default is not 2.1"
    guids = {guid for guid, *_ in topics_of(default)}
    (folder / "structure.obj").write_text(cubes(reversed(STRUCTURE)))
    (folder / "services.obj").write_text(cubes(reversed(SERVICES)))
    run(soms, *base, "-o", default)
    if {guid for guid, *_ in topics_of(default)} != guids:
        yield "other numbers of parts give other GUIDs"
    os.utime(folder / "services.obj", (1e9, 1e9))
    os.utime(folder / "structure.obj", (1.1e9, 1.1e9))
    environment = {k: v for k, v in os.environ.items() if k != "SOURCE_DATE_EPOCH"}
    subprocess.run([soms, *map(str, base), "-o", default], check=True, capture_output=True, env=environment)
    if {m.find("Topic/CreationDate").text for _, m, *_ in topics_of(default)} != {"2004-11-09T11:33:20Z"}:
        yield "an archive is not as old as its newest model"
    wrong = subprocess.run([soms, *map(str, base), "-o", default], capture_output=True, text=True, check=False, env={**environment, "SOURCE_DATE_EPOCH": "soon"})
    if wrong.returncode != 2 or "SOURCE_DATE_EPOCH" not in wrong.stderr:
        yield f"SOURCE_DATE_EPOCH=soon: {wrong.returncode}, {wrong.stderr}"
    useless = subprocess.run([soms, *map(str, base), "--no-snapshots"], capture_output=True, text=True, check=False)
    if useless.returncode != 2 or "no effect" not in useless.stderr:
        yield f"--no-snapshots alone: {useless.returncode}, {useless.stderr}"
    run(soms, *base, "-o", default, "--no-snapshots")
    if any(picture is not None or markup.find(".//Snapshot") is not None for _, markup, _, picture in topics_of(default)):
        yield "--no-snapshots leaves pictures"


def baseline_faults(soms, folder, schemas):
    """What is resolved is closed, with a view of where it was."""
    (folder / "structure.obj").write_text(cubes(STRUCTURE))
    (folder / "services.obj").write_text(cubes(SERVICES))
    base = ["clash", folder / "structure.obj", "--against", folder / "services.obj"]
    run(soms, *base, "-o", folder / "old.json")
    (folder / "services.obj").write_text(cubes([SERVICES[1], ("Duct", (1, 2, 1), (4, 2.5, 1.4)), ("Drain", (0.1, 1, 1), (2, 1.2, 1.2))]))
    archive = folder / "later.bcf"
    run(soms, *base, "--baseline", folder / "old.json", "-o", archive, "-o", folder / "later.json", "--bcf-version", "3.0")
    rows = json.loads((folder / "later.json").read_text())["rows"]
    if sorted(row["status"] for row in rows) != ["active", "new", "resolved", "resolved"]:
        yield f"statuses {[row['status'] for row in rows]}"
    found = {markup.find("Topic").get("Guid"): markup.find("Topic").get("TopicStatus") for _, markup, *_ in topics_of(archive)}
    wanted = {str(uuid.uuid5(NAMESPACE, "topic " + row["key"])): {"new": "Open", "active": "Active", "resolved": "Closed"}[row["status"]] for row in rows}
    if found != wanted:
        yield f"statuses of topics are {found}, not {wanted}"
    if schemas:
        yield from invalid(schemas, "3.0", archive, folder / "later")
    old = json.loads((folder / "old.json").read_text())
    odd = {**old["rows"][0], "key": "0123456789abcdef", "group": "level\n1"}
    for member in ("place", "box", "triangle_pairs"):
        del odd[member]
    (folder / "odd.json").write_text(json.dumps({**old, "rows": [odd], "pairs": 1}))
    for member, value in (("place", "nowhere"), ("box", [1, 2]), ("a", 7), ("triangle_pairs", "\u0001many")):
        (folder / "wrong.json").write_text(json.dumps({**old, "rows": [{**odd, member: value}], "pairs": 1}))
        refused = subprocess.run([soms, *base, "--baseline", folder / "wrong.json"], capture_output=True, text=True)
        if refused.returncode != 3 or f"rows[0], {member}: expected" not in refused.stderr:
            yield f"{member}: {refused.returncode} {refused.stderr}"
    for version in ("2.1", "3.0"):
        run(soms, *base, "--baseline", folder / "odd.json", "-o", archive, "-o", folder / "odd.html", "--bcf-version", version)
        topics = list(topics_of(archive))
        if sum(view is None for _, _, view, _ in topics) != 1:
            yield f"{version}: a row without a place has a view"
        if schemas:
            yield from invalid(schemas, version, archive, folder / "odd")


def ifc_faults(soms, folder):
    """An id that is an IFC GUID is one; another names the part for the tool that knows it."""
    guid = "3vB2YO$MX4xv5uCqZZG05x"
    city = {"type": "CityJSON", "version": "2.0", "metadata": {"referenceSystem": "urn:ogc:def:crs:EPSG::7415"}, "transform": {"scale": [1, 1, 1], "translate": [0, 0, 0]}, "CityObjects": {}, "vertices": []}
    for name, low in ((guid, 0), ("tree-7", 0.5)):
        first = len(city["vertices"])
        city["vertices"] += [[int(10 * (low + (k & 1))), int(10 * (low + (k >> 1 & 1))), int(10 * (low + (k >> 2)))] for k in range(8)]
        city["CityObjects"][name] = {"type": "Building", "geometry": [{"type": "MultiSurface", "lod": "1", "boundaries": [[[first + corner for corner in face]] for face in CUBE]}]}
    (folder / "city.city.json").write_text(json.dumps(city))
    archive = folder / "city.bcfzip"
    run(soms, "clash", folder / "city.city.json", "-o", archive)
    topics = list(topics_of(archive))
    if len(topics) != 1:
        yield f"{len(topics)} clashes of two cubes"
        return
    parts = {part.get("IfcGuid"): part.findtext("AuthoringToolId") for part in topics[0][2].iter("Component")}
    if parts != {guid: None, None: "tree-7"}:
        yield f"components are {parts}"
    if "georeference: EPSG:7415" not in topics[0][1].find("Topic").find("Description").text:
        yield "the topic does not say where on the Earth it lies"


def building_faults(soms, folder, schemas):
    """Every clash of a building is a topic that its schema allows."""
    base = ["clash", MODELS / "structure.obj", "--against", MODELS / "services.gltf", "-o", folder / "building.json"]
    for version in ("2.1", "3.0"):
        archive = folder / f"building-{version}.bcfzip"
        run(soms, *base, "-o", archive, "--bcf-version", version)
        rows = json.loads((folder / "building.json").read_text())["rows"]
        if sum(row["triangle_pairs"] > 0 for row in rows) != 260:
            yield f"{sum(row['triangle_pairs'] > 0 for row in rows)} pairs meet"
        guids = [guid for guid, *_ in topics_of(archive)]
        if guids != [str(uuid.uuid5(NAMESPACE, "topic " + row["key"])) for row in rows]:
            yield f"{version}: topics of a building are not its rows"
        if schemas:
            yield from invalid(schemas, version, archive, folder / "building")


def main():
    soms = sys.argv[1]
    data = pathlib.Path(os.environ["SOMS_DATA"]) if os.environ.get("SOMS_DATA") else None
    schemas = data / "bcf" if data and shutil.which("xmllint") else None
    if schemas is None:
        print("skipped: schemas of BCF, which need SOMS_DATA and xmllint (libxml2-utils of section test in packages.txt)")
    found = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        found += small_faults(soms, folder, schemas)
        found += baseline_faults(soms, folder, schemas)
        found += ifc_faults(soms, folder)
        found += building_faults(soms, folder, schemas)
    for line in found:
        print(line)
    print(f"{len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
