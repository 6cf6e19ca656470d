"""What a cluster costs beside the answers themselves: processor time, as a share of one process that answers all rows.

    cluster_overhead.py CAR CITY POSES FOLDER [SECONDS]

Shards take SECONDS (2) of processor time. Counted are the worker, which has the models, and the driver with its scheduler;
beside it what a process without Dask needs to answer and write the same rows in one file.
"""
import pathlib
import sys
import time

import distributed

from soms import _shards, cluster


def main():
    car, city, poses, folder = sys.argv[1:5]
    seconds = float(sys.argv[5]) if len(sys.argv) > 5 else 2.0
    question = {"mode": "any", "pairs": False}
    folder = pathlib.Path(folder)
    one = _shards.job_of("overlap", car, city, poses, folder / "one", question)
    _shards.work(one, (0, 1000))  # builds the trees
    rows = _shards.identity(one)["of"]
    begin = time.process_time()
    _shards.work(one, (0, rows))
    alone = time.process_time() - begin
    shard_rows = max(1, int(rows * seconds / alone))
    many = _shards.job_of("overlap", car, city, poses, folder / "many", question)
    with distributed.LocalCluster(n_workers=1, threads_per_worker=1, memory_limit=0, dashboard_address=None) as local, \
            distributed.Client(local) as client:
        client.submit(_shards.trial, many, (0, 1000)).result()
        begin, worker = time.process_time(), sum(client.run(time.process_time).values())
        answer = cluster.run(many, client=client, shard_rows=shard_rows)
        driver = time.process_time() - begin
        worker = sum(client.run(time.process_time).values()) - worker
    begin = time.process_time()
    _shards.join(folder / "many", _shards.there(folder / "many"), folder / "again.npz")
    joined = time.process_time() - begin
    same = answer.read_bytes() == (folder / f"one/{_shards.name_of((0, rows))}.npz").read_bytes()
    print(f"{rows:,} rows in {-(-rows // shard_rows)} shards of {seconds:.1f} s: alone {alone:.2f} s of processor time, worker "
          f"{worker:.2f} s, driver {driver:.2f} s, of which joining {joined:.2f} s; overhead {100 * ((worker + driver) / alone - 1):.1f} %; "
          f"same bytes: {same}")


if __name__ == "__main__":
    main()
