"""Poses shared out by Dask: the bytes of one machine for any number of workers, and after whatever ends them."""
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import unittest

try:
    import dask
    import distributed  # noqa: F401  (what is missing is said below)
except ImportError as error:
    print(f"skipped: {error}; apt install python3-distributed")
    sys.exit(77)

import numpy as np

import soms
import soms.dask
from cluster_models import (POISON, ROWS, bytes_of_one_machine, dying, job_in, make_files, modules, poisoned, receipts, start,
                            wait_until, without_disk, written)
from soms import _shards, cluster

KILLS = 20
SHARD = 50  # rows


class Clusters(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        modules()
        cls.kept = tempfile.TemporaryDirectory()
        cls.files = make_files(cls.kept.name)
        cls.expected = bytes_of_one_machine(cls.files)

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def setUp(self):
        self.folder = pathlib.Path(self.kept.name) / self._testMethodName

    def record(self):
        return json.loads((self.folder / "job.json").read_bytes())

    def check(self, path):
        self.assertEqual(pathlib.Path(path).read_bytes(), self.expected)
        self.assertEqual((self.record()["state"], self.record()["rows_done"]), ("done", ROWS))

    def run_here(self, **options):
        options = {"workers": 2, "shard_rows": SHARD, **options}
        return cluster.run(job_in(self.files, self.folder), **options)


class Answers(Clusters):
    def test_any_number_of_workers(self):
        for workers in (1, 2, 7):
            self.folder = pathlib.Path(self.kept.name) / f"workers-{workers}"
            self.check(self.run_here(workers=workers, shard_rows=400))

    def test_every_verb_with_a_trial(self):
        paths = [self.files / name for name in ("car.ply", "city.ply", "poses.npy")]
        with distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as local, \
                distributed.Client(local) as client:
            for verb, given, options in (("overlap", paths, {"mode": "any", "pairs": False}), ("distance", paths, {"at_most": 5.0}),
                                         ("within", [*paths[:2], 4.0, paths[2]], {})):
                answer = getattr(soms.dask, verb)(*given, out=self.folder / verb, client=client, **options)
                question = {"clearance": 4.0} if verb == "within" else options
                self.assertEqual((self.folder / verb / "answer.npz").read_bytes(),
                                 bytes_of_one_machine(self.files, verb, question))
                self.assertEqual(len(answer["coverage"]), ROWS)
            # What a user of Dask writes first.
            shape = soms.Shape(soms.read_mesh(paths[1]))
            future = client.submit(soms.overlap, shape, shape, np.eye(4)[None])
            self.assertEqual(future.result(), soms.overlap(shape, shape, np.eye(4)[None]))

    def test_what_is_there_is_not_answered_again(self):
        self.check(self.run_here())
        for path in sorted(self.folder.glob("shard-*"))[10:14]:
            path.unlink()
        seen = []
        self.check(self.run_here(say=seen.append))
        self.assertIn(f"{ROWS:,} of {ROWS:,} rows", seen[-1])

    def test_errors_name_rows_of_the_whole(self):
        poses = np.load(self.files / "poses.npy")
        poses[777, 1] = np.nan
        np.save(self.files / "broken.npy", poses)
        job = {**job_in(self.files, self.folder), "poses": str(self.files / "broken.npy")}
        with self.assertRaises(soms.Error) as caught:
            cluster.run(job, workers=1, shard_rows=SHARD)
        self.assertIn("777", str(caught.exception))
        self.assertEqual(self.record()["state"], "failed")

    def test_a_folder_of_another_run_is_refused(self):
        self.check(self.run_here(shard_rows=ROWS))
        job = job_in(self.files, self.folder, question={"mode": "first", "pairs": True})
        with self.assertRaises(soms.Error) as caught:
            cluster.run(job, workers=1)
        self.assertIn("its question differs", str(caught.exception))


    def test_what_is_not_there_is_named(self):
        """By the command, too: a line, and no traceback."""
        files, gone = self.files, "/nonexistent/there"
        for change, kind, named in (({"a": gone}, "cannot_open", gone), ({"b": f"{gone}/"}, "cannot_open", gone),
                                    ({"poses": gone}, "cannot_open", gone),
                                    ({"folder": files / "car.ply"}, "cannot_write", "car.ply")):
            given = {"a": files / "car.ply", "b": files / "city.ply", "poses": files / "poses.npy", "folder": self.folder,
                     **change}
            with self.assertRaises(soms.Error) as caught:
                _shards.job_of("overlap", given["a"], given["b"], given["poses"], given["folder"], {})
            self.assertEqual(caught.exception.kind, kind)
            self.assertIn(named, caught.exception.place)
            command = subprocess.run([sys.executable, "-m", "soms.cluster", "overlap", given["a"], given["b"], "--pose",
                                      given["poses"], "-o", given["folder"]], capture_output=True, text=True)
            self.assertEqual((command.returncode, command.stderr.count("\n")), (3, 1), command.stderr)
            self.assertIn(named, command.stderr)

    def test_a_scheduler_that_does_not_answer_is_named(self):
        with dask.config.set({"distributed.comm.timeouts.connect": "1s"}), self.assertRaises(soms.Error) as caught:
            cluster.run(job_in(self.files, self.folder), scheduler="tcp://127.0.0.1:1")
        self.assertEqual(caught.exception.kind, "cannot_open")
        self.assertIn("127.0.0.1:1", caught.exception.place)


class Faults(Clusters):
    def test_killed_workers(self):
        self.folder.mkdir()
        for i in random.Random(20).sample(range(0, ROWS, SHARD), KILLS):
            (self.folder / f"die-{'late-' if i % 200 else ''}{i}").touch()
        self.check(self.run_here(task=dying))
        self.assertEqual(list(self.folder.glob("die-*")), [])
        self.assertGreaterEqual(self.record()["deaths"], KILLS)

    def test_a_poison_pose_fails_alone(self):
        with self.assertRaises(soms.Error) as caught:
            self.run_here(task=poisoned)
        self.assertIn(str(POISON), str(caught.exception))
        record = self.record()
        self.assertEqual(([failed["row"] for failed in record["failed"]], record["rows_done"]), ([POISON], ROWS - 1))
        self.check(self.run_here())

    def test_a_full_disk_stops_all_and_keeps_what_is_done(self):
        with self.assertRaises(soms.Error) as caught:
            self.run_here(task=without_disk)
        self.assertEqual(caught.exception.kind, "cannot_write")
        done = receipts(self.folder)
        self.assertGreaterEqual(done, ROWS // 2 // SHARD)
        self.assertEqual(list(self.folder.glob("*.part")), [])
        self.check(self.run_here())

    def test_two_drivers_of_one_folder(self):
        drivers = [start(self.files, self.folder, "--workers", 1, "--shard-rows", SHARD) for _ in range(2)]
        for driver in drivers:
            out, errors = driver.communicate()
            self.assertEqual(driver.returncode, 0, errors)
            self.check(out.strip())

    def test_an_interrupted_command_goes_on(self):
        driver = start(self.files, self.folder, "--workers", 1, "--shard-rows", 5)
        self.assertTrue(wait_until(lambda: receipts(self.folder) >= 3, driver))
        os.killpg(driver.pid, signal.SIGINT)
        _, errors = driver.communicate()
        self.assertEqual(driver.returncode, 130, errors)
        self.assertIn("the same command goes on", errors)
        self.assertLess(receipts(self.folder), ROWS // 5)
        self.assertEqual(self.record()["state"], "interrupted")
        again = start(self.files, self.folder, "--workers", 2)
        out, errors = again.communicate()
        self.assertEqual(again.returncode, 0, errors)
        self.check(out.strip())

    def test_a_scheduler_is_killed_and_restarted(self):
        with tempfile.TemporaryDirectory() as place:
            file = f"{place}/scheduler.json"
            first = self.cluster_of_processes(file, 0)
            port = json.loads(pathlib.Path(file).read_bytes())["address"].rpartition(":")[2]
            driver = start(self.files, self.folder, "--scheduler", f"tcp://127.0.0.1:{port}", "--shard-rows", 5)
            self.assertTrue(wait_until(lambda: receipts(self.folder) >= 20, driver))
            self.end(first)
            second = self.cluster_of_processes(file, port)
            out, errors = driver.communicate()
            self.end(second)
            self.assertEqual(driver.returncode, 0, errors)
            self.check(out.strip())

    def cluster_of_processes(self, file, port):
        """A scheduler and a worker, as a cluster has them on several machines."""
        pathlib.Path(file).unlink(missing_ok=True)
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "start_new_session": True}
        scheduler = subprocess.Popen([sys.executable, "-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port",
                                      str(port), "--no-dashboard", "--scheduler-file", file], **quiet)
        self.assertTrue(wait_until(lambda: written(file), scheduler))
        worker = subprocess.Popen([sys.executable, "-m", "distributed.cli.dask_worker", "--scheduler-file", file, "--nthreads", "1",
                                   "--no-dashboard"], **quiet)
        return scheduler, worker

    @staticmethod
    def end(processes):
        for process in processes:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()


if __name__ == "__main__":
    unittest.main()
