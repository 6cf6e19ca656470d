"""Queries of many poses by the workers of a Dask cluster.

    import soms.dask

    answer = soms.dask.overlap("car.ply", "city.ply", "poses.npy", out="answers")
    print(answer["any"].sum())

Models and poses are files that every worker can read. Without a client a LocalCluster is started, a
process for each processor. The answer is that of one machine, byte by byte: out/answer.npz, whose columns
are those of `-o FILE.npz`. What is in `out` is not computed again, so an interrupted call is repeated. Needs
the package distributed. Raises Error; kind out_of_memory names rows whose workers died again and again.
"""

import os
from typing import Any, Optional, Union

import numpy as np

from soms import _shards, cluster

_Path = Union[str, "os.PathLike[str]"]


def overlap(mover: _Path, fixed: _Path, poses: _Path, *, out: _Path, mode: str = "all", pairs: bool = True,
            client: Any = None, workers: Optional[int] = None) -> Any:
    """overlap(mover, fixed, poses, *, out, mode='all', pairs=True, client=None, workers=None)

    As soms.overlap; pairs: lists them, otherwise counts. Returns the arrays of out/answer.npz.
    """
    question = {"mode": mode, "pairs": pairs}
    return _run("overlap", mover, fixed, poses, out, question, client, workers)


def distance(mover: _Path, fixed: _Path, poses: _Path, *, out: _Path, at_most: Optional[float] = None,
             client: Any = None, workers: Optional[int] = None) -> Any:
    """distance(mover, fixed, poses, *, out, at_most=None, client=None, workers=None)

    As soms.distance. Returns the arrays of out/answer.npz.
    """
    question = {} if at_most is None else {"at_most": float(at_most)}
    return _run("distance", mover, fixed, poses, out, question, client, workers)


def within(mover: _Path, fixed: _Path, clearance: float, poses: _Path, *, out: _Path, client: Any = None,
           workers: Optional[int] = None) -> Any:
    """within(mover, fixed, clearance, poses, *, out, client=None, workers=None)

    As soms.within. Returns the arrays of out/answer.npz.
    """
    return _run("within", mover, fixed, poses, out, {"clearance": float(clearance)}, client, workers)


def _run(verb: str, mover: _Path, fixed: _Path, poses: _Path, out: _Path, question: Any, client: Any,
         workers: Optional[int]) -> Any:
    job = _shards.job_of(verb, mover, fixed, poses, out, question)
    return np.load(cluster.run(job, client=client, workers=workers))
