# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""A small part of benchmarks/trial_ground: ground_test.py COMMAND. Each log is of a kind that must be
right, and a map that is bent on its way to the judge must not be."""
import json
import math
import os
import pathlib
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "benchmarks"))

from trial.kinds import KINDS  # noqa: E402 (after the path is set)
from trial.outputs import mapped_poses  # noqa: E402
from trial.real_logs import base_of, real_trials, run_real_trial  # noqa: E402
from trial.trials import Trial, judged, run_trial, spoilt_log  # noqa: E402

COMMAND = None
# Kind, level, seed.
MUST_BE_RIGHT = [("plain", 0, 3), ("plain", 1, 1), ("posts", 0, 2), ("dust", 0, 1),
                 ("odometry-jump", 0, 2), ("turn-on-the-spot", 2, 1)]
# Nothing shows how far the robot drove: the map may be off, within the spread that it reports.
MUST_NOT_BE_SILENT = [("corridor-bare", 0, 2), ("corridor-bare", 2, 1), ("round-alone", 0, 2),
                      ("round-odometry", 1, 2)]


def bend_half(folder, angle_rad):
    """Turns the second half of folder/poses.tsv about its first pose."""
    path = folder / "poses.tsv"
    header, *rows = [line.split("\t") for line in path.read_text().splitlines()]
    x_m, y_m, heading_deg = (header.index(name) for name in ("x_m", "y_m", "heading_deg"))
    middle = len(rows) // 2
    x0, y0 = float(rows[middle][x_m]), float(rows[middle][y_m])
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    for row in rows[middle:]:
        x, y = float(row[x_m]) - x0, float(row[y_m]) - y0
        row[x_m], row[y_m] = f"{x0 + c * x - s * y:.6f}", f"{y0 + s * x + c * y:.6f}"
        row[heading_deg] = f"{float(row[heading_deg]) + math.degrees(angle_rad):.5f}"
    path.write_text("".join("\t".join(row) + "\n" for row in [header, *rows]))
    return middle, len(rows)


def lose(folder, first):
    """Says in folder/poses.tsv that the scans from `first` on are lost."""
    path = folder / "poses.tsv"
    header, *rows = [line.split("\t") for line in path.read_text().splitlines()]
    for row in rows[first:]:
        row[header.index("doubts")] = "lost"
    path.write_text("".join("\t".join(row) + "\n" for row in [header, *rows]))


def change_run(folder, change):
    path = folder / "run.json"
    run = json.loads(path.read_text())
    change(run)
    path.write_text(json.dumps(run))


def outcomes_of(trials):
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(lambda trial: run_trial(COMMAND, Trial(*trial)), trials))


class Ground(unittest.TestCase):
    def test_kinds_that_must_be_right(self):
        for outcome in outcomes_of(MUST_BE_RIGHT):
            with self.subTest(outcome):
                self.assertEqual(outcome["wrong"], 0)
                self.assertGreaterEqual(outcome["placed"], 0.97 * outcome["poses"])
                self.assertGreater(outcome["poses"], 300)
                self.assertLess(outcome["median_m"], 0.1)

    def test_kinds_that_must_not_be_silent(self):
        for outcome in outcomes_of(MUST_NOT_BE_SILENT):
            with self.subTest(outcome):
                self.assertEqual(outcome["silent"], 0)
                self.assertGreater(outcome["placed"], 300)

    def test_a_map_bent_by_hand_is_wrong_and_silent_unless_it_says_so(self):
        with tempfile.TemporaryDirectory() as name:
            trial, folder = Trial("plain", 0, 3), pathlib.Path(name)
            self.assertEqual(run_trial(COMMAND, trial, folder)["silent"], 0)
            kept = folder / "plain-0-3"
            scans = spoilt_log(COMMAND, trial, kept)
            middle, _ = bend_half(kept / "map", math.radians(20.0))

            def verdict():
                return judged(scans, mapped_poses(kept / "map")[0])
            self.assertTrue(verdict().is_wrong_and_silent)
            change_run(kept / "map", lambda run: run["findings"].append({"kind": "odometry_jumps"}))
            self.assertTrue(verdict().is_wrong_and_silent)  # That says nothing of the map.
            change_run(kept / "map", lambda run: run["findings"].append({"kind": "few_beams"}))
            self.assertEqual(verdict().num_silent, 0)
            self.assertGreater(verdict().num_wrong, 0)
            lose(kept / "map", middle)
            self.assertEqual((verdict().num_silent, verdict().num_placed), (0, middle))

    def test_faults_are_put_into_a_log_that_is_there(self):
        """A simulated one here, of which only `setsquare map` knows the truth."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            spoilt_log(COMMAND, Trial("plain", 0, 3), folder)
            base_of(COMMAND, folder / "log.jsonl", folder / "base")
            trials = real_trials([folder / "log.jsonl"], ["as it is", "half missing", "mirrored"], [1])
            for trial in trials:
                outcome = run_real_trial(COMMAND, trial, folder / "base")
                with self.subTest(outcome):
                    self.assertEqual((outcome["silent"], outcome["kind"]), (0, trial.fault))
                    self.assertGreater(outcome["poses"], 300)
                    self.assertGreaterEqual(outcome["placed"], 0.97 * outcome["poses"])
            self.assertEqual([trial.mode for trial in trials],
                             ["odometry", "alone", "odometry", "alone", "odometry"])

    def test_no_two_levels_of_a_kind_share_a_name(self):
        for kind, levels in KINDS.items():
            self.assertEqual(len({level.name for level in levels}), len(levels), kind)


if __name__ == "__main__":
    COMMAND = sys.argv.pop(1)
    unittest.main()
