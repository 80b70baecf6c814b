# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Runs of the command on the real logs, each at most once, and their figures."""
import functools
import json
import pathlib
import re
import statistics
import subprocess
import tempfile
import time

LOGS = ("intel", "aces", "fr079")
NUM_TIMED_RUNS = 3


class Runs:
    """The command, the folder of logs, and a temporary folder for what the command writes."""

    def __init__(self, options):
        self.command = options.command
        self.commit = options.commit
        self.benchmarks = pathlib.Path(options.benchmarks)
        self.heading_test = pathlib.Path(options.heading_test)
        self._data = pathlib.Path(options.data) if options.data else None
        self._paper_json = options.paper_json
        self._folder = tempfile.TemporaryDirectory(prefix="setsquare-figures-")
        self.out = pathlib.Path(self._folder.name)

    def file(self, log, ending):
        """A file of a log: file("intel", "loop.relations") is intel/intel.loop.relations."""
        if self._data is None:
            raise SystemExit("update_results: --data FOLDER or SETSQUARE_DATA_DIR must name the logs")
        return str(self._data / log / f"{log}.{ending}")

    def run(self, *arguments):
        """Standard output and standard error of the command."""
        return self.start(self.command, *arguments)

    @staticmethod
    def start(*command):
        """Standard output and standard error of a program."""
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                              check=False)
        if done.returncode != 0:
            raise SystemExit(f"update_results: {' '.join(map(str, command))}: {done.stderr}")
        return done.stdout, done.stderr

    def map_folder(self, log, odometry):
        return str(self.out / f"{log}-{'with' if odometry else 'without'}")

    def map_wall_s(self, log, odometry):
        """Maps a log; returns the wall time of the whole process, reading and writing included."""
        options = [] if odometry else ["--no-odometry"]
        start = time.monotonic()
        self.run("map", self.file(log, "clf"), "-o", self.map_folder(log, odometry), *options)
        return time.monotonic() - start

    @functools.lru_cache(maxsize=None)
    def map_times_s(self, log):
        """Median wall times with odometry and without, the runs taking turns."""
        times_s = {True: [], False: []}
        for _ in range(NUM_TIMED_RUNS):
            for odometry in (True, False):
                times_s[odometry].append(self.map_wall_s(log, odometry))
        return {odometry: statistics.median(values) for odometry, values in times_s.items()}

    @functools.lru_cache(maxsize=None)
    def mapped(self, log, odometry):
        """The folder of a log's map."""
        folder = self.map_folder(log, odometry)
        if not pathlib.Path(folder, "run.json").exists():
            self.map_wall_s(log, odometry)
        return folder

    @functools.lru_cache(maxsize=None)
    def relations(self, log, odometry):
        """evaluate relations --json of a map."""
        trajectory = self.mapped(log, odometry) + "/trajectory.tum"
        return json.loads(
            self.run("evaluate", "relations", trajectory, self.file(log, "relations"), "--json")[0])

    @functools.lru_cache(maxsize=None)
    def closures(self, log, odometry):
        """evaluate closures --json of a map."""
        closures = self.mapped(log, odometry) + "/closures.tsv"
        return json.loads(
            self.run("evaluate", "closures", closures, self.file(log, "relations"), "--json")[0])

    @functools.lru_cache(maxsize=None)
    def chains(self, log):
        return json.loads(self.run("evaluate", "chains", self.file(log, "relations"), "--json")[0])

    @functools.lru_cache(maxsize=None)
    def pairs(self, log, kind, preset="default"):
        """The summary of match --pairs, by its rows; median times are medians of three runs, those
        of the two presets taking turns."""
        summaries = {"default": [], "paper": []}
        for _ in range(NUM_TIMED_RUNS):
            for name, found in summaries.items():
                found.append(self._summary(log, kind, name))
        summary = summaries[preset][0]
        times_us = [each["all"]["time_us"] for each in summaries[preset]]
        summary["all"]["time_us"] = statistics.median(times_us)
        return summary

    def _summary(self, log, kind, preset):
        table = str(self.out / "pairs.tsv")
        relations = self.file(log, f"{kind}.relations")
        text = self.run("match", self.file(log, "clf"), "--pairs", relations, "--preset", preset,
                        "-o", table)[1]
        row = re.compile(r"^(all|overlap .*?)\s+(\d+)\s+([\d.]+)%\s+([\d.]+)%\s+([\d.]+)%\s+(\d+)\s"
                         r".*?([\d.]+) us\s*$", re.MULTILINE)
        summary = {}
        for name, number, success, tight, matched, wrong, time_us in row.findall(text):
            summary[name] = {"number": int(number), "success": float(success),
                             "tight": float(tight), "matched": float(matched),
                             "wrong": int(wrong), "time_us": float(time_us)}
        if "all" not in summary:
            raise SystemExit("update_results: the summary of match --pairs is not understood:\n" + text)
        return summary

    @functools.lru_cache(maxsize=None)
    def paper_json(self):
        if self._paper_json:
            return json.loads(pathlib.Path(self._paper_json).read_text())
        folder = self.out / "paper"
        self.run("experiment", "paper", "-o", str(folder))
        return json.loads((folder / "paper.json").read_text())
