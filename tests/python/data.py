"""The truth sets of tests/data, for the tests of the Python package."""
import csv
import functools
import lzma
import os
import pathlib

import numpy as np

import soms

DATA = pathlib.Path(__file__).resolve().parent.parent / "data"
MODELS = os.environ.get("SOMS_DATA")


def rows(name):
    """Rows of a packed table, as dictionaries."""
    with lzma.open(DATA / f"{name}.csv.xz", "rt", encoding="utf-8", newline="") as text:
        yield from csv.DictReader(text)


@functools.cache
def _files():
    with open(DATA / "truth/meshes.csv", encoding="utf-8", newline="") as text:
        files = {row["mesh"]: row["file"] for row in csv.DictReader(text)}
    found = {}
    for name, file in files.items():
        if not file.startswith("../"):
            found[name] = DATA / "truth" / file
        elif MODELS:
            found[name] = pathlib.Path(MODELS) / file[len("../"):]
    for folder in ("questions", "motion"):
        for path in (DATA / folder / "meshes").glob("*.ply"):
            found.setdefault(path.stem, path)
    return found


@functools.cache
def shape(name):
    """A shape of the truth sets, or None where its file is one of others and absent."""
    path = _files().get(name)
    return soms.Shape(soms.read_mesh(path)) if path and path.exists() else None


@functools.cache
def closed(name):
    return soms.ClosedBody(soms.Body(shape(name)))


def pose(row, letter):
    """A pose (3, 4) of the columns a0 to a11, or b0 to b11."""
    return np.array([float(row[f"{letter}{i}"]) for i in range(12)]).reshape(3, 4)


def point(row, letter):
    return np.array([float(row[f"{letter}{axis}"]) for axis in "xyz"])


def groups(table, *keys):
    """Rows by the values of columns, in their order."""
    found = {}
    for row in table:
        found.setdefault(tuple(row[key] for key in keys), []).append(row)
    return found
