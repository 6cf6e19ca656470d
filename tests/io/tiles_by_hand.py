"""Sample tiles, read by hand: struct and json alone say what soms must make of them.

    tiles_by_hand.py SOMS

Counts, ids, attributes, every corner of every triangle, boxes; that all corners lie in the regions
that the tiles declare, by a conversion of its own; and that ids reach the answers of clash and
overlap. The data is in $SOMS_DATA/tiles; without it the test says that it is skipped.
"""
import json
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile

SKIPPED = 77
COMPONENTS = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}
COUNTS = {"SCALAR": 1, "VEC3": 3}


def parse_glb(data):
    """The document and the binary chunk."""
    assert data[:4] == b"glTF" and struct.unpack_from("<I", data, 4) == (2,)
    length, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON"
    return json.loads(data[20:20 + length]), data[28 + length:]


def parse_b3dm(data):
    """Feature table, batch table and glTF."""
    magic, version, size, *lengths = struct.unpack_from("<4s6I", data)
    assert magic == b"b3dm" and version == 1 and size == len(data)
    at = 28
    sections = []
    for length in lengths:
        sections.append(data[at:at + length])
        at += length
    assert not sections[1] and not sections[3]
    return json.loads(sections[0]), json.loads(sections[2] or b"{}"), data[at:]


def accessor(document, binary, number):
    """Rows of an accessor, as tuples."""
    stated = document["accessors"][number]
    view = document["bufferViews"][stated["bufferView"]]
    letters = COUNTS[stated["type"]] * COMPONENTS[stated["componentType"]]
    stride = view.get("byteStride") or struct.calcsize("<" + letters)
    begin = view.get("byteOffset", 0) + stated.get("byteOffset", 0)
    return [struct.unpack_from("<" + letters, binary, begin + i * stride)
            for i in range(stated["count"])]


def placed(matrix, p):
    """A point moved by a matrix of columns."""
    return tuple(sum(matrix[4 * k + i] * p[k] for k in range(3)) + matrix[12 + i] for i in range(3))


IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


def triangles_of(glb, center):
    """Triangles in the axes of the tile, each with its batch."""
    document, binary = parse_glb(glb)
    found = []
    for node in document["nodes"]:
        matrix = node.get("matrix", IDENTITY)
        for primitive in document["meshes"][node["mesh"]]["primitives"]:
            attributes = primitive["attributes"]
            corners = []
            for p in accessor(document, binary, attributes["POSITION"]):
                x, y, z = placed(matrix, p)
                corners.append((x + center[0], -z + center[1], y + center[2]))
            batches = ([int(b) for b, in accessor(document, binary, attributes["_BATCHID"])]
                       if "_BATCHID" in attributes else [None] * len(corners))
            indices = [i for i, in accessor(document, binary, primitive["indices"])]
            for i in range(0, len(indices), 3):
                three = indices[i:i + 3]
                assert len({batches[k] for k in three}) == 1
                found.append((batches[three[0]], [corners[k] for k in three]))
    return found


def on_earth(p):
    """Longitude, latitude and height, by repeated correction of the latitude."""
    a, flattening = 6378137.0, 1 / 298.257223563
    e2 = flattening * (2 - flattening)
    across = math.hypot(p[0], p[1])
    latitude = math.atan2(p[2], across * (1 - e2))
    height = 0.0
    for _ in range(20):
        n = a / math.sqrt(1 - e2 * math.sin(latitude) ** 2)
        height = across / math.cos(latitude) - n
        latitude = math.atan2(p[2], across * (1 - e2 * n / (n + height)))
    return math.atan2(p[1], p[0]), latitude, height


def in_region(region, p):
    west, south, east, north, lowest, highest = region
    longitude, latitude, height = on_earth(p)
    by = 1e-4  # meters, which floats of the size of a tile may lose
    angle = by / 6.3e6
    return (west - angle <= longitude <= east + angle and south - angle <= latitude <= north + angle
            and lowest - by <= height <= highest + by)


class Soms:
    def __init__(self, program):
        self.program = program

    def run(self, *words, statuses=(0, 1)):
        done = subprocess.run([self.program, *map(str, words)], capture_output=True, text=True,
                              check=False)
        assert done.returncode in statuses, (words, done.returncode, done.stderr)
        return done.stdout

    def info(self, model):
        return json.loads(self.run("info", model, "--json"))

    def corners(self, model):
        """Corners of all triangles, as soms writes them."""
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "out.ply"
            self.run("convert", model, out)
            data = out.read_bytes()
        head, body = data.split(b"end_header\n", 1)
        counts = dict(line.split()[1:] for line in head.decode().splitlines()
                      if line.startswith("element"))
        assert b"property double z" in head
        vertices = list(struct.iter_unpack("<3d", body[:24 * int(counts["vertex"])]))
        faces = body[24 * int(counts["vertex"]):]
        triangles = []
        for row in struct.iter_unpack("<B3I", faces[:13 * int(counts["face"])]):
            assert row[0] == 3
            triangles.append([vertices[i] for i in row[1:]])
        return triangles


def box_of(triangles):
    points = [p for _, corners in triangles for p in corners]
    return [[f(p[i] for p in points) for i in range(3)] for f in (min, max)]


def check_box(report, triangles):
    lower, upper = box_of(triangles)
    assert report["bounds"] == [lower, upper], (report["bounds"], lower, upper)


def check_city(soms, folder):
    """City 1.0: four tiles of ten buildings each, in Earth-centered coordinates."""
    tileset = json.loads((folder / "tileset.json").read_text())
    report = soms.info(folder / "tileset.json")
    expected = []
    parts = []
    for tile in tileset["root"]["children"]:
        uri = tile["content"]["uri"]
        features, table, glb = parse_b3dm((folder / uri).read_bytes())
        triangles = triangles_of(glb, features["RTC_CENTER"])
        alone = soms.info(folder / uri)
        assert alone["triangles"] == len(triangles) and alone["up_axis"] is None
        check_box(alone, triangles)
        outside = [p for _, corners in triangles for p in corners
                   if not in_region(tile["boundingVolume"]["region"], p)]
        assert not outside, (uri, len(outside))
        parts.append((uri, None, len(triangles), {}))
        for batch in range(features["BATCH_LENGTH"]):
            count = sum(1 for b, _ in triangles if b == batch)
            parts.append((f"{uri}/{table['id'][batch]}", batch, count,
                          {name: column[batch] for name, column in table.items()}))
        expected += triangles
    assert report["triangles"] == len(expected) and not report["notes"], report["notes"]
    check_box(report, expected)
    assert len(report["parts"]) == len(parts) == 44
    for found, (name, batch, count, attributes) in zip(report["parts"], parts):
        assert found["triangles"] == count
        assert found["id"] == (name if batch is not None else None), (found["id"], name)
        assert found["name"] == (name if batch is None else str(batch))
        stated = {a["name"]: json.loads(a["value"]) for a in found["attributes"]}
        assert stated == attributes, (stated, attributes)
    assert soms.corners(folder / "tileset.json") == [corners for _, corners in expected]
    print(f"city_1_0: {len(expected)} triangles, {len(parts)} parts, all in their regions")


def check_ids(soms, folder):
    """The ids of batches in the answers of clash and overlap."""
    tile = folder / "ll.b3dm"
    lines = soms.run("clash", tile, "--against", folder / "tileset.json", "--json").splitlines()
    rows = [json.loads(line) for line in lines]
    pairs = {(row["a"]["id"], row["b"]["id"], row["class"]) for row in rows if "a" in row}
    assert pairs == {(str(i), f"ll.b3dm/{i}", "same") for i in range(10)}, pairs
    text = soms.run("overlap", folder / "tileset.json", tile, "--by", "part")
    assert all(f"ll.b3dm/{i} and {i}:" in text for i in range(10)), text
    print(f"clash and overlap: {len(pairs)} pairs with ids")


def check_dragon(soms, model):
    features, _, glb = parse_b3dm(model.read_bytes())
    assert features == {"BATCH_LENGTH": 0}
    triangles = triangles_of(glb, (0, 0, 0))
    report = soms.info(model)
    assert report["triangles"] == len(triangles) and report["up_axis"] == "z"
    check_box(report, triangles)
    assert soms.corners(model) == [corners for _, corners in triangles]
    print(f"dragon: {len(triangles)} triangles")


def check_boxes(soms, folder):
    """Boxes of 3D Tiles 1.1: glTF in tiles with box volumes, which they fill."""
    tilesets = sorted(folder.glob("*/tileset.json"))
    assert len(tilesets) == 6
    for file in tilesets:
        root = json.loads(file.read_text())["root"]
        triangles = triangles_of((file.parent / root["content"]["uri"]).read_bytes(), (0, 0, 0))
        report = soms.info(file)
        assert report["triangles"] == len(triangles) == 12 and not report["notes"]
        check_box(report, triangles)
        n = root["boundingVolume"]["box"]
        half = [max(abs(n[3 + 3 * k + i]) for k in range(3)) for i in range(3)]
        assert report["bounds"] == [[n[i] - half[i] for i in range(3)],
                                    [n[i] + half[i] for i in range(3)]], report["bounds"]
    print(f"boxes_1_1: {len(tilesets)} tilesets, each fills its volume")


def main():
    folder = pathlib.Path(os.environ.get("SOMS_DATA", "/nonexistent")) / "tiles"
    if not folder.is_dir():
        print("SOMS_DATA is unset or has no tiles: skipped 11 tiles of others")
        return SKIPPED
    soms = Soms(sys.argv[1])
    check_city(soms, folder / "city_1_0")
    check_ids(soms, folder / "city_1_0")
    check_dragon(soms, folder / "dragon_low.b3dm")
    check_boxes(soms, folder / "boxes_1_1")
    return 0


if __name__ == "__main__":
    sys.exit(main())
