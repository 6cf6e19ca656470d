"""Unpacks the truth sets into a folder that node and a browser read: prepare.py ROOT OUT.

OUT gets truth/, distance/, questions/ and motion/ with their tables, meshes/ with all meshes of the sets, and meshes.csv with
their names; formats/ and bad/ have files of each format, good and broken.
"""
import lzma
import pathlib
import shutil
import sys

SETS = ("truth", "distance", "questions", "motion")


def prepare(root, out):
    data = root / "tests" / "data"
    (out / "meshes").mkdir(parents=True, exist_ok=True)
    names = []
    for name in SETS:
        (out / name).mkdir(exist_ok=True)
        for packed in sorted((data / name).glob("*.csv.xz")):
            (out / name / packed.stem).write_bytes(lzma.decompress(packed.read_bytes()))
        for mesh in sorted((data / name / "meshes").glob("*.ply")):
            shutil.copy(mesh, out / "meshes" / mesh.name)
            names.append(mesh.stem)
    (out / "meshes.csv").write_text("\n".join(["mesh", *names]) + "\n", encoding="utf-8")
    for folder in ("formats", "bad"):
        shutil.copytree(data / folder, out / folder, dirs_exist_ok=True)


if __name__ == "__main__":
    prepare(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
