"""Answers about many poses by the workers of a Dask cluster; `python -m soms.cluster --help` says how.

Tasks carry paths and ranges of rows and return receipts; answers go to files. The folder decides what is
done: rows whose answers are there are not answered again, and the same command goes on after any end.
"""

import argparse
import errno
import json
import os
import pathlib
import sys
import time
from typing import Any, Callable, Dict, List, Optional

import soms
from soms import _shards
from soms._shards import Job, Range

SECONDS = 5.0  # that a task takes: its cost is a hundredth of that, and a kill loses little
TRIAL = 0.1  # seconds of rows whose time is taken
FIRST = 256  # rows of the first trial
BLAMED = 2  # deaths after which rows run alone, so that it is they that are to blame
POLL = 0.02  # seconds between two looks at running tasks
PATIENCE = 600  # seconds, for the trial
FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG}
SAME = ("version", "question", "models", "poses", "of")  # in all drivers and workers of a folder


class Driver:
    """Brings the answers of a job into its folder."""

    def __init__(self, job: Job, connect: Callable[[], Any], task: Callable[[Job, Range], Any],
                 say: Callable[[str], Any], revive: Callable[[], Any] = lambda: None) -> None:
        self.job, self.connect, self.task, self.say, self.revive = job, connect, task, say, revive
        self.folder = pathlib.Path(job["folder"])
        self.identity = _shards.identity(job)
        self.rows: int = self.identity["of"]
        try:
            self.client = connect()
        except OSError as error:
            raise soms.Error("cannot_open", f"no scheduler answers: {error}", "check its address") from None
        self.running: Dict[Any, Range] = {}
        self.queue: List[Range] = []
        self.alone: List[Range] = []  # rows that workers died of, to run while nothing else does
        self.deaths: Dict[Range, int] = {}
        self.killed = self.answered = self.done = self.workers = 0
        self.failed: List[int] = []
        self.begin, self.shown = time.monotonic(), 0.0

    def run(self, shard_rows: Optional[int]) -> pathlib.Path:
        state = "failed"
        self.shard_rows = self.agreed(shard_rows)
        try:
            while gaps := self.gaps(_shards.there(self.folder)):
                self.queue = gaps[::-1]
                self.done = self.rows - sum(end - begin for begin, end in gaps)
                self.answer_all()
                if self.failed:
                    raise soms.Error("out_of_memory", f"workers died of rows {sorted(self.failed)[:10]}",
                                     f"look at these poses; {self.folder}/job.json has all")
            _shards.join(self.folder, _shards.there(self.folder), self.folder / "answer.npz")
            state = "done"
        except KeyboardInterrupt:
            state = "interrupted"
            raise
        finally:
            for future in self.running:
                future.cancel()
            self.show(True)
            self.record(state)
        return self.folder / "answer.npz"

    def agreed(self, shard_rows: Optional[int]) -> int:
        """Rows of a task, which the first driver of the folder decides for all."""
        path = self.folder / "job.json"
        if not path.exists():
            self.shard_rows = shard_rows or self.tried()
            part = self.folder / f".job-{os.getpid()}.part"
            self.record("running", part)
            try:
                os.link(part, path)  # of two drivers one is first
            except FileExistsError:
                pass
            part.unlink()
        there = json.loads(path.read_bytes())
        for key in SAME:
            if there.get(key) != self.identity[key]:
                raise soms.Error("bad_file", f"{path}: is of another run: its {key} differs",
                                 "give another folder, or remove what is in this one")
        return int(there["shard_rows"])

    def tried(self) -> int:
        """As many rows as take about SECONDS, by trials on a worker."""
        count, seconds = min(FIRST, self.rows), 0.0
        while self.rows:
            future = self.client.submit(_shards.trial, self.job, (0, count), pure=False)
            try:
                seconds = future.result(timeout=PATIENCE)
            except Exception as error:
                if type(error).__name__ in ("KilledWorker", "TimeoutError", "CancelledError"):
                    return FIRST
                raise
            if seconds > TRIAL or count == self.rows:
                break
            count = min(self.rows, 8 * count)
        return max(1, int(count * SECONDS / max(seconds, 1e-6)))

    def gaps(self, parts: List[Range]) -> List[Range]:
        """What is not done, in pieces that end where shards do."""
        gaps, begin = [], 0
        for part in [*parts, (self.rows, self.rows)]:
            while begin < part[0]:
                end = min(part[0], (begin // self.shard_rows + 1) * self.shard_rows)
                gaps.append((begin, end))
                begin = end
            begin = part[1]
        return gaps or ([] if parts else [(0, 0)])

    def answer_all(self) -> None:
        while self.queue or self.alone or self.running:
            while self.queue and len(self.running) < 2 * max(1, self.workers):
                self.submit(self.queue.pop())
            if self.alone and not self.queue and not self.running:
                self.submit(self.alone.pop())
            time.sleep(POLL)
            for future in [future for future in self.running if future.status != "pending"]:
                self.take(future, self.running.pop(future))
            while self.client.status != "running":
                self.reconnect()
            self.show(False)

    def submit(self, rows: Range) -> None:
        if _shards.receipt_of(self.folder, rows):  # another driver's, or of a task that seemed lost
            self.done += rows[1] - rows[0]
        else:
            self.running[self.client.submit(self.task, self.job, rows, pure=False)] = rows

    def take(self, future: Any, rows: Range) -> None:
        error = future.exception() if future.status == "error" else None
        receipt = _shards.receipt_of(self.folder, rows)
        if receipt:  # of the folder: a result in the memory of a worker that died makes Dask wait for it
            for key in SAME:
                if receipt[key] != self.identity[key]:
                    raise soms.Error("bad_file", f"{key} of a worker differ from those here",
                                     "give all machines the same files and the same soms")
            self.done += rows[1] - rows[0]
            self.answered += rows[1] - rows[0]
        elif error is None:  # cancelled or lost, as the scheduler is, or the file
            self.queue.append(rows)
        elif type(error).__name__ == "KilledWorker":
            self.blame(rows)
        elif isinstance(error, OSError) and error.errno in FULL:
            raise soms.Error("cannot_write", f"{self.folder}: {os.strerror(error.errno or 0)}",
                             "free some space, then run the same command: what is done stays")
        else:
            raise error

    def blame(self, rows: Range) -> None:
        self.killed += 1
        deaths = self.deaths[rows] = self.deaths.get(rows, 0) + 1
        middle = (rows[0] + rows[1]) // 2
        if deaths < BLAMED:
            self.queue.append(rows)
        elif deaths == BLAMED or (rows[1] - rows[0] == 1 and deaths == BLAMED + 1):
            self.alone.append(rows)
        elif rows[1] - rows[0] == 1:
            self.failed.append(rows[0])
        else:
            for half in ((rows[0], middle), (middle, rows[1])):
                self.deaths[half] = BLAMED
                self.alone.append(half)

    def reconnect(self) -> None:
        self.queue += self.running.values()
        self.running = {}
        if self.client.status == "closed":
            self.say("\nthe scheduler is gone: waiting for it\n")
            try:
                self.client = self.connect()
            except OSError:
                pass
        time.sleep(POLL)

    def show(self, last: bool) -> None:
        now = time.monotonic()
        if last or now - self.shown > 1:
            self.shown = now
            self.revive()
            self.workers = len(self.client.scheduler_info().get("workers", ()))
            rate = self.answered / max(now - self.begin, 1e-9)
            left = f"{(self.rows - self.done) / rate:,.0f} s left" if rate else ""
            self.say(f"\r{self.done:,} of {self.rows:,} rows, {rate:,.0f} rows/s, {self.workers} workers, "
                     f"{self.killed} deaths, {left}  " + ("\n" if last else ""))

    def record(self, state: str, path: Optional[pathlib.Path] = None) -> None:
        failed = [{"row": row, "why": "its worker died"} for row in sorted(self.failed)]
        _shards.put_json(path or self.folder / "job.json", {
            **self.identity, "schema": "soms.job/1", "shard_rows": self.shard_rows, "state": state,
            "rows_done": self.done, "deaths": self.killed, "failed": failed})


def run(job: Job, *, client: Any = None, scheduler: Optional[str] = None, workers: Optional[int] = None,
        shard_rows: Optional[int] = None, task: Callable[[Job, Range], Any] = _shards.work,
        say: Callable[[str], Any] = lambda text: None) -> pathlib.Path:
    """Answers a job by a client's cluster, a scheduler's, or a LocalCluster; the path of the answer."""
    try:
        import dask
        import distributed
    except ImportError as error:
        raise soms.Error("unsupported", f"Dask is not there: {error}",
                         "apt install python3-distributed, or pip install distributed") from None
    if client is not None or scheduler is not None:
        return Driver(job, lambda: client or distributed.Client(scheduler), task, say).run(shard_rows)
    # Deaths are reported at once. Memory is not Dask's to limit: it would pause workers for good.
    workers = workers or os.cpu_count()
    with dask.config.set({"distributed.scheduler.allowed-failures": 0}), distributed.LocalCluster(
            n_workers=workers, threads_per_worker=1, memory_limit=0,
            dashboard_address=None) as local, distributed.Client(local) as own:
        return Driver(job, lambda: own, task, say, lambda: local.scale(workers)).run(shard_rows)


def _options() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m soms.cluster", description=(__doc__ or "").splitlines()[0])
    verbs = parser.add_subparsers(dest="verb", required=True)
    for verb in ("overlap", "distance", "within"):
        one = verbs.add_parser(verb)
        one.add_argument("a", help="model that moves")
        one.add_argument("b", help="model that stays")
        one.add_argument("--pose", required=True, help="file of poses of A; rows of .npy are read where they are")
        one.add_argument("-o", "--output", required=True, help="folder; its answer.npz is the answer")
        one.add_argument("--workers", type=int, help="processes on this machine (default: one a processor)")
        one.add_argument("--scheduler", help="address of a Dask scheduler, tcp://HOST:8786, instead")
        one.add_argument("--shard-rows", type=int, help=f"rows of a task (default: as many as take {SECONDS:.0f} s)")
        if verb == "overlap":
            one.add_argument("--any", dest="mode", action="store_const", const="any", default="all")
            one.add_argument("--first", dest="mode", action="store_const", const="first")
            one.add_argument("--no-pairs", dest="pairs", action="store_false", help="count the pairs")
        elif verb == "distance":
            one.add_argument("--at-most", type=float, help="only say that they are farther apart, if they are")
        else:
            one.add_argument("--clearance", type=float, required=True)
    return parser


def main() -> int:
    given = vars(_options().parse_args())
    question = {key: given[key] for key in ("mode", "pairs", "at_most", "clearance") if given.get(key) is not None}
    try:
        job = _shards.job_of(given["verb"], given["a"], given["b"], given["pose"], given["output"], question)
        print(run(job, scheduler=given["scheduler"], workers=given["workers"], shard_rows=given["shard_rows"],
                  say=lambda text: print(text, end="", file=sys.stderr, flush=True)))
    except soms.Error as error:
        print(f"soms.cluster: {error}", file=sys.stderr)
        return 3
    except KeyboardInterrupt:
        print(f"soms.cluster: interrupted; the same command goes on in {given['output']}", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
