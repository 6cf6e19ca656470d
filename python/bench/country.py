"""Cuts many cities into tiles and asks about them in little memory: COUNT cities of TRIANGLES triangles, side by side.

usage: python3 country.py SOMS FOLDER [--cities 100] [--triangles 1000000] [--memory 2G] [--rows 10000]

FOLDER needs 110 bytes a triangle. Every program runs under a limit of its address space (--memory). The answers are compared with
those of each city as a model of its own, put together here: of poses that meet one city alone.
"""
import argparse
import os
import pathlib
import resource
import subprocess
import time

import numpy as np
import soms

SIDE = 4200.0  # between the middles of two cities


def limited(size):
    def begin():
        resource.setrlimit(resource.RLIMIT_AS, (size, size))
    return begin


def run(words, size):
    started = time.monotonic()
    subprocess.run([str(word) for word in words], check=True, preexec_fn=limited(size), stdout=subprocess.DEVNULL)
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    print(f"{words[1]:9} {time.monotonic() - started:7.2f} s, at most {peak / 1024:.0f} MB resident so far", flush=True)


def shifted(mesh, number, columns):
    vertices = np.array(mesh.vertices)
    vertices += [SIDE * (number % columns), SIDE * (number // columns), 0]
    return soms.Mesh(vertices, np.array(mesh.triangles))


def make_cities(soms_command, folder, count, triangles):
    columns = int(np.ceil(np.sqrt(count)))
    paths = []
    for number in range(count):
        path = folder / f"city-{number:03}.ply"
        paths.append(path)
        if not path.exists():
            subprocess.run([soms_command, "generate", "city", "--triangles", str(triangles), "--seed", str(number % 4 + 1), "--extent", "4000", "--streets", "bare",
                            "-o", path, "--quiet"], check=True)
            soms.write_mesh(str(path), shifted(soms.read_mesh(str(path)), number, columns))
    return paths, columns


def random_poses(rng, count, columns, rows):
    """Poses of a car near the ground of some city, and which."""
    city = rng.integers(0, count, rows)
    poses = np.zeros((rows, 3, 4))
    poses[:, 0, 0] = poses[:, 1, 1] = poses[:, 2, 2] = 1
    poses[:, :2, 3] = rng.uniform(-1900, 1900, (rows, 2)) + SIDE * np.stack([city % columns, city // columns], 1)
    poses[:, 2, 3] = rng.uniform(-6, 40, rows)
    return poses, city


def compare(car, paths, poses, city, answer, triangles):
    """Rows whose answer differs from that of their city."""
    wrong = 0
    for number in np.unique(city):
        rows = np.flatnonzero(city == number)
        shape = soms.Shape(soms.read_mesh(str(paths[number])))
        alone = soms.distance(car, soms.Body(shape), poses[rows])
        pairs = np.array(alone.triangles, dtype=np.int64) + [0, number * triangles]
        same = (alone.lower == answer["lower"][rows]) & (alone.upper == answer["upper"][rows])
        same &= (pairs == answer["triangles"][rows]).all(1)
        wrong += np.count_nonzero(~same)
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("soms")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--cities", type=int, default=100)
    parser.add_argument("--triangles", type=int, default=1000000)
    parser.add_argument("--memory", type=float, default=2, help="GB of address space")
    parser.add_argument("--rows", type=int, default=10000)
    wanted = parser.parse_args()
    folder, size = wanted.folder, int(wanted.memory * 1e9)
    folder.mkdir(exist_ok=True)
    paths, columns = make_cities(wanted.soms, folder, wanted.cities, wanted.triangles)
    subprocess.run([wanted.soms, "generate", "car", "-o", folder / "car.ply", "--quiet"], check=True)
    poses, city = random_poses(np.random.default_rng(1), wanted.cities, columns, wanted.rows)
    np.save(folder / "poses.npy", poses)
    run([wanted.soms, "tile", *paths, "-o", folder / "tiles", "--quiet"], size)
    common = [folder / "car.ply", folder / "tiles", "--pose", folder / "poses.npy", "--max-memory", f"{int(wanted.memory * 250)}M", "--quiet"]
    run([wanted.soms, "overlap", *common, "-o", folder / "overlap.npz"], size)
    run([wanted.soms, "distance", *common, "-o", folder / "distance.npz"], size)
    run([wanted.soms, "within", *common, "--clearance", "2", "-o", folder / "within.npz"], size)
    car = soms.Shape(soms.read_mesh(str(folder / "car.ply")))
    wrong = compare(car, paths, poses, city, np.load(folder / "distance.npz"), wanted.triangles)
    print(f"{wanted.cities * wanted.triangles:,} triangles, {wanted.rows:,} distances, {wrong} differ from those of single cities")
    raise SystemExit(1 if wrong else 0)


if __name__ == "__main__":
    os.environ.pop("SOMS_THREADS", None)
    main()
