"""What tests of clusters share: a job, the bytes that one machine answers, and tasks that die on purpose."""
import json
import os
import pathlib
import resource
import signal
import subprocess
import sys
import time

import numpy as np

import soms
from soms import _shards, cluster

ROWS = 3000
POISON = 1234
QUESTION = {"mode": "all", "pairs": True}


def make_files(folder):
    """car.ply, city.ply, poses.npy."""
    folder = pathlib.Path(folder)
    soms.write_mesh(folder / "car.ply", soms.generate("car", 384))
    city = soms.generate("city", 5672)
    soms.write_mesh(folder / "city.ply", city)
    lower, upper = city.bounds
    place = np.random.default_rng(7).uniform(lower, upper, (ROWS, 3))
    place[:, 2] = -3
    np.save(folder / "poses.npy", place)
    return folder


def job_in(files, folder, verb="overlap", question=None):
    question = QUESTION if question is None else question
    return _shards.job_of(verb, files / "car.ply", files / "city.ply", files / "poses.npy", folder, question)


def bytes_of_one_machine(files, verb="overlap", question=None):
    """By one call of the library, which tests/python/shards_test.py compares with what the command writes."""
    folder = files / f"one-{verb}"
    job = job_in(files, folder, verb, question)
    _shards.work(job, (0, ROWS))
    return (folder / f"{_shards.name_of((0, ROWS))}.npz").read_bytes()


def take(marker):
    """Whether this process is the one that a marker was for."""
    try:
        os.unlink(marker)
    except FileNotFoundError:
        return False
    return True


def dying(job, rows):
    """The task; where a marker lies, its process is killed before the answer or before the receipt."""
    folder = pathlib.Path(job["folder"])
    if take(folder / f"die-{rows[0]}"):
        os.kill(os.getpid(), signal.SIGKILL)
    if take(folder / f"die-late-{rows[0]}"):
        _shards.put_json = lambda path, value: os.kill(os.getpid(), signal.SIGKILL)
    return _shards.work(job, rows)


def poisoned(job, rows):
    if rows[0] <= POISON < rows[1]:
        os.kill(os.getpid(), signal.SIGKILL)
    return _shards.work(job, rows)


def without_disk(job, rows):
    """The task; from the middle on files may have 100 bytes."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    if rows[0] >= ROWS // 2:
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, hard))
    try:
        return _shards.work(job, rows)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def wait_until(happened, child=None):
    """Waits for an event; false if the child ended before."""
    while not happened():
        if child is not None and child.poll() is not None:
            return happened()
        time.sleep(0.01)
    return True


def written(file):
    """The file of a scheduler holds its address. It is there, empty, before it is written."""
    try:
        return "address" in json.loads(pathlib.Path(file).read_bytes())
    except (OSError, ValueError):
        return False


def start(files, folder, *more):
    """The command line of the driver as a process of a group of its own."""
    words = [sys.executable, "-m", "soms.cluster", "overlap", files / "car.ply", files / "city.ply", "--pose",
             files / "poses.npy", "-o", folder, *more]
    return subprocess.Popen([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            start_new_session=True)


def receipts(folder):
    return len(list(pathlib.Path(folder).glob("shard-*.json")))


def modules():
    """For workers, which find neither this folder nor, where it is not installed, soms."""
    paths = [str(pathlib.Path(__file__).parent), str(pathlib.Path(cluster.__file__).parents[1])]
    os.environ["PYTHONPATH"] = os.pathsep.join([*paths, os.environ.get("PYTHONPATH", "")])
