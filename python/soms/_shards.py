"""Answers of some rows of poses as files with receipts, and all of them as one file: byte by byte what the
command writes by --shard and `soms join`."""

import functools
import hashlib
import json
import os
import pathlib
import re
import struct
import tempfile
import time
import zlib
from typing import Any, Callable, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

import soms

ENDS = 65536  # bytes of each end of a file of poses that identify it

Job = Dict[str, Any]  # verb, a, b, poses (paths), folder, options of the query, pairs
Range = Tuple[int, int]


class Column(NamedTuple):
    name: str
    type: str
    shape: Tuple[int, ...]
    pieces: Callable[[], Iterator[Any]]  # arrays one after the other


def job_of(verb: str, a: Any, b: Any, poses: Any, folder: Any, question: Any) -> Job:
    """A job of these files. Makes the folder. An error names what is not there, or cannot be written."""
    paths = {key: os.path.abspath(os.fspath(value)) for key, value in
             {"a": a, "b": b, "poses": poses, "folder": folder}.items()}
    for key in ("a", "b", "poses"):
        try:
            os.stat(paths[key])
        except OSError as error:
            raise soms.Error("cannot_open", f"{paths[key]}: {error.strerror}", "check the path") from None
    try:
        os.makedirs(paths["folder"], exist_ok=True)
    except OSError as error:
        raise soms.Error("cannot_write", f"{paths['folder']}: {error.strerror}", "name a folder for the answer") from None
    return {"verb": verb, "question": question, **paths}


@functools.lru_cache(maxsize=4)
def _file(path: str, changed: int) -> Union[soms.Mesh, soms.Shape, soms.TileSet]:
    if os.path.isdir(path):
        return soms.TileSet(path)
    with open(path, "rb") as file:
        is_tree = file.read(8) == b"\x89SOMT\r\n\x1a"
    return soms.open_shape(path) if is_tree else soms.read_mesh(path)


@functools.lru_cache(maxsize=4)
def _shape(path: str, changed: int) -> Union[soms.Shape, soms.TileSet]:
    held = _file(path, changed)
    return soms.Shape(held) if isinstance(held, soms.Mesh) else held


def _changed(path: str) -> int:
    """When a file was written, or the manifest of a folder of tiles."""
    return os.stat(os.path.join(path, "tiles.json") if os.path.isdir(path) else path).st_mtime_ns


def shape(path: str) -> Union[soms.Shape, soms.TileSet]:
    """The shape of a model or a tree file, or tiles, built or opened once in each process."""
    return _shape(path, _changed(path))


def _georeference(path: str) -> Optional[soms.Georeference]:
    held = shape(path)
    return held.georeference if isinstance(held, soms.TileSet) else held.mesh.georeference


@functools.lru_cache(maxsize=2)
def _poses(path: str, changed: int) -> Any:
    with open(path, "rb") as file:
        is_array = file.read(6) == b"\x93NUMPY"
    return np.load(path, mmap_mode="r") if is_array else soms.read_poses(path)


def poses(path: str) -> Any:
    """All poses of a file; those of an array file are not read before they are used."""
    return _poses(path, os.stat(path).st_mtime_ns)


@functools.lru_cache(maxsize=8)
def _model(path: str, changed: int) -> Dict[str, Any]:
    held = _file(path, changed)
    mesh = held.mesh if isinstance(held, soms.Shape) else held
    return {"triangles": len(mesh), "hash": f"{mesh.hash():016x}"}


def identity(job: Job) -> Dict[str, Any]:
    """What all shards of an answer have in common, as receipts have it."""
    path, size = job["poses"], os.stat(job["poses"]).st_size
    with open(path, "rb") as file:
        ends = file.read(min(size, ENDS))
        file.seek(size - len(ends))
        ends += file.read()
    rows = len(poses(path))
    question = {"verb": job["verb"], **job["question"]}
    models = {side: _model(job[side], _changed(job[side])) for side in "ab"}
    return {"schema": "soms.shard/1", "version": soms.__version__, "question": question, "models": models,
            "poses": {"a": {"rows": rows, "bytes": size, "ends": hashlib.sha256(ends).hexdigest()}, "b": None},
            "of": rows}


# Columns of answers, in the order of their fields.
FIELDS = {"distance": ("lower", "upper", "farther", "triangles", "point_a", "point_b"),
          "within": ("within", "at_least", "triangles", "point_a", "point_b")}


def columns_of(job: Job, answer: Any) -> List[Column]:
    """An answer about several poses as the columns of `-o FILE.npz`."""
    def column(name: str, type: str, values: Any, *shape: int) -> Column:
        return Column(name, type, shape, lambda: iter([np.asarray(values)]))

    def text(name: str, words: Sequence[str]) -> Column:
        return column(name, f"<U{max(map(len, words))}", np.array(words))
    coverage = column("coverage", "|u1", answer.coverage)
    names = text("coverage_names", [one.name for one in soms.Coverage])
    if job["verb"] == "overlap":
        any_ = column("any", "|b1", answer.any)
        if not job["question"]["pairs"]:
            count = column("count", "<i8", np.diff(answer.offsets.astype("<i8")))
            return [any_, count, coverage, names]
        return [any_, column("offsets", "<i8", answer.offsets), column("pairs", "<i8", answer.pairs, 2), coverage, names]
    fields = []
    for name in FIELDS[job["verb"]]:
        values = np.asarray(getattr(answer, name))
        if name.startswith("point"):
            values = np.where(answer.triangles[:, :1] < 0, np.nan, values)  # there is no pair
        fields.append(column(name, {"b": "|b1", "f": "<f8", "i": "<i8"}[values.dtype.kind], values, *values.shape[1:]))
    placed = _georeference(job["b"])
    where = [text("georeference", [str(placed)])] if placed else []
    return [*fields, coverage, names, *where]


def _head(type: str, rows: int, shape: Tuple[int, ...]) -> bytes:
    sizes = f"({rows},)" if not shape else f"({', '.join(map(str, (rows, *shape)))})"
    text = f"{{'descr': '{type}', 'fortran_order': False, 'shape': {sizes}, }}"
    text = text.ljust((10 + len(text) + 64) // 64 * 64 - 11) + "\n"
    return b"\x93NUMPY\x01\0" + struct.pack("<H", len(text)) + text.encode()


def write_npz(out: Any, columns: List[Column]) -> None:
    """Writes the archive that the command writes: members as they are, sizes in 64 bits, no times."""
    members, begin = [], out.tell()
    for name, type, shape, pieces in columns:
        rows = sum(len(piece) for piece in pieces())
        head, file = _head(type, rows, shape), f"{name}.npy".encode()
        size = len(head) + rows * int(np.prod(shape, dtype=int)) * np.dtype(type).itemsize
        at, checksum = out.tell() - begin, zlib.crc32(head)
        local = struct.pack("<HHQQ", 1, 16, size, size)
        out.write(bytes(30) + file + local + head)
        for piece in pieces():
            data = np.ascontiguousarray(piece, dtype=type).tobytes()
            checksum = zlib.crc32(data, checksum)
            out.write(data)
        end = out.tell()
        out.seek(begin + at)
        out.write(struct.pack("<IHHHHHIIIHH", 0x04034B50, 45, 0, 0, 0, 0x21, checksum, 0xFFFFFFFF, 0xFFFFFFFF,
                              len(file), len(local)))
        out.seek(end)
        members.append((file, checksum, size, at))
    first = out.tell() - begin
    for file, checksum, size, at in members:
        out.write(struct.pack("<IHHHHHHIIIHHHHHII", 0x02014B50, 3 << 8 | 45, 45, 0, 0, 0, 0x21, checksum,
                              0xFFFFFFFF, 0xFFFFFFFF, len(file), 28, 0, 0, 0, 0o100644 << 16, 0xFFFFFFFF))
        out.write(file + struct.pack("<HHQQQ", 1, 24, size, size, at))
    end = out.tell() - begin
    out.write(struct.pack("<IQHHIIQQQQ", 0x06064B50, 44, 45, 45, 0, 0, len(members), len(members), end - first, first))
    out.write(struct.pack("<IIQI", 0x07064B50, 0, end, 1))
    out.write(struct.pack("<IHHHHIIH", 0x06054B50, 0, 0, len(members), len(members), 0xFFFFFFFF, 0xFFFFFFFF, 0))


def put(path: pathlib.Path, write: Callable[[Any], None]) -> None:
    """A file that appears whole or not at all, also where power is lost."""
    handle, part = tempfile.mkstemp(prefix=".soms-", suffix=".part", dir=path.parent)
    try:
        with os.fdopen(handle, "wb") as out:
            write(out)
            out.flush()
            os.fchmod(out.fileno(), 0o644)
            os.fsync(out.fileno())
        os.replace(part, path)
    except BaseException:
        os.unlink(part)
        raise


def put_json(path: pathlib.Path, value: Any) -> None:
    put(path, lambda out: out.write((json.dumps(value, separators=(",", ":")) + "\n").encode()))


def name_of(rows: Range) -> str:
    return f"shard-{rows[0]:012}-{rows[1]:012}"


def receipt_of(folder: pathlib.Path, rows: Range) -> Optional[Dict[str, Any]]:
    """The receipt of these rows, if their answers are there and as long as it says."""
    try:
        receipt: Dict[str, Any] = json.loads((folder / f"{name_of(rows)}.json").read_bytes())
        size = (folder / f"{name_of(rows)}.npz").stat().st_size
        return receipt if receipt["files"]["npz"]["bytes"] == size else None
    except (FileNotFoundError, ValueError, KeyError, TypeError):
        return None


def there(folder: pathlib.Path) -> List[Range]:
    """Rows that are answered, in order; of those that overlap the first and longest."""
    names = [path.stem.split("-") for path in folder.glob("shard-*-*.json")]
    found: List[Range] = []
    for begin, less in sorted((int(begin), -int(end)) for _, begin, end in names):
        if (not found or begin >= found[-1][1]) and receipt_of(folder, (begin, -less)):
            found.append((begin, -less))
    return found


def answer(job: Job, rows: Range) -> Any:
    """The library's answer of these rows. Errors name rows of the whole."""
    a, b, part = shape(job["a"]), shape(job["b"]), poses(job["poses"])[rows[0]:rows[1]]
    try:
        if job["verb"] == "within":
            return soms.within(a, b, job["question"]["clearance"], part)
        options = {key: value for key, value in job["question"].items() if key != "pairs"}
        return getattr(soms, job["verb"])(a, b, part, **options)
    except soms.Error as error:
        place = re.sub(r"^pose (\d+)", lambda row: f"pose {int(row[1]) + rows[0]}", error.place)
        raise soms.Error(error.kind, place, error.remedy) from None


def work(job: Job, rows: Range) -> Dict[str, Any]:
    """The task: answers rows, writes them and their receipt, and returns the receipt."""
    shape(job["a"]), shape(job["b"])
    begin = time.perf_counter()
    columns = columns_of(job, answer(job, rows))
    folder = pathlib.Path(job["folder"])
    file = folder / f"{name_of(rows)}.npz"
    put(file, lambda out: write_npz(out, columns))
    with open(file, "rb") as written:
        entry = {"bytes": os.fstat(written.fileno()).st_size, "sha256": hashlib.sha256(written.read()).hexdigest()}
    receipt = {**identity(job), "rows": list(rows), "files": {"npz": entry}}
    put_json(folder / f"{name_of(rows)}.json", receipt)
    return {**receipt, "seconds": time.perf_counter() - begin}


def trial(job: Job, rows: Range) -> float:
    """Seconds that an answer of these rows takes, without writing."""
    shape(job["a"]), shape(job["b"])
    begin = time.perf_counter()
    columns_of(job, answer(job, rows))
    return time.perf_counter() - begin


def join(folder: pathlib.Path, parts: List[Range], out: pathlib.Path) -> None:
    """Puts the answers of all parts together. Raises Error of kind bad_file for damaged ones."""
    files = [_checked(folder, rows) for rows in parts]

    def pieces(name: str) -> Iterator[Any]:
        listed = 0
        for i, file in enumerate(files):
            with np.load(file) as arrays:
                values = arrays[name]
            if name == "offsets":
                values, listed = values[min(i, 1):] + listed, listed + int(values[-1])
            yield values
            if values.dtype.kind == "U":  # words of codes, and what models state: of no row
                return
    with np.load(files[0]) as arrays:
        first = {name: arrays[name] for name in arrays.files}
    columns = [Column(name, values.dtype.str, values.shape[1:], functools.partial(pieces, name))
               for name, values in first.items()]
    put(out, lambda to: write_npz(to, columns))


def _checked(folder: pathlib.Path, rows: Range) -> pathlib.Path:
    file, receipt = folder / f"{name_of(rows)}.npz", receipt_of(folder, rows)
    if receipt is None or hashlib.sha256(file.read_bytes()).hexdigest() != receipt["files"]["npz"]["sha256"]:
        raise soms.Error("bad_file", f"{file}: does not have the bytes that its receipt states",
                         "remove it and its receipt, then run again")
    return file
