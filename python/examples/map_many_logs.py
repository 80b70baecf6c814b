# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""python map_many_logs.py FOLDER LOG...: maps logs on a Dask cluster and writes one table.

Each log is one task of one thread, and its map goes to FOLDER/NAME; FOLDER/logs.tsv has a row a
log. Without --scheduler the cluster is this machine. Needs Debian's python3-distributed.
"""
import argparse
import csv
import pathlib
import resource
import time

from distributed import Client, as_completed

import setsquare

COLUMNS = ["log", "scans", "verdict", "doubts", "time_s", "worker_peak_mb"]


def map_one(log, folder):
    """A row of the table. What is wrong with one log stops no other."""
    start = time.perf_counter()
    try:
        building = setsquare.map_log(log, num_threads=1)
        building.save(folder, num_threads=1)
        row = {"scans": len(building), "verdict": building.verdict, "doubts": len(building.doubts)}
    except setsquare.Error as error:
        row = {"scans": 0, "verdict": f"error: {error}", "doubts": ""}
    peak_mb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return {"log": log, **row, "time_s": f"{time.perf_counter() - start:.2f}",
            "worker_peak_mb": f"{peak_mb:.0f}"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("logs", nargs="+")
    parser.add_argument("--scheduler", help="address of a cluster, tcp://HOST:8786")
    parser.add_argument("--workers", type=int, help="processes on this machine (one a core)")
    options = parser.parse_args()
    cluster = options.scheduler or {"n_workers": options.workers, "threads_per_worker": 1,
                                    "dashboard_address": None}
    options.folder.mkdir(parents=True, exist_ok=True)
    with Client(cluster) if options.scheduler else Client(**cluster) as client:
        tasks = [client.submit(map_one, log, str(options.folder / pathlib.Path(log).stem), pure=False)
                 for log in options.logs]
        rows = []
        for number, task in enumerate(as_completed(tasks), start=1):
            rows.append(task.result())
            print(f"{number} of {len(tasks)}: {rows[-1]['log']}: {rows[-1]['verdict']}", flush=True)
    with open(options.folder / "logs.tsv", "w", encoding="utf-8", newline="") as file:
        table = csv.DictWriter(file, COLUMNS, delimiter="\t")
        table.writeheader()
        table.writerows(sorted(rows, key=lambda row: options.logs.index(row["log"])))


if __name__ == "__main__":
    main()
