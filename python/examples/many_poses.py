"""Where does a car stand free in a city? Poses shared out by Dask over the processors of this machine.

    many_poses.py [POSES] [FOLDER]

What is in FOLDER already is not answered again.
"""
import pathlib
import sys
import tempfile

import numpy as np

import soms
import soms.dask


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp(prefix="soms-"))
    folder.mkdir(parents=True, exist_ok=True)
    city = soms.generate("city", 5672)
    soms.write_mesh(folder / "city.ply", city)
    soms.write_mesh(folder / "car.ply", soms.generate("car"))
    lower, upper = city.bounds
    poses = np.random.default_rng(1).uniform(lower, upper, (count, 3))
    poses[:, 2] = -1
    np.save(folder / "poses.npy", poses)
    answer = soms.dask.overlap(folder / "car.ply", folder / "city.ply", folder / "poses.npy", out=folder / "answers",
                               mode="any", pairs=False)
    print(f"{np.count_nonzero(~answer['any'])} of {count} poses are free; {folder}/answers/answer.npz has them")


if __name__ == "__main__":
    main()
