# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Recordings that others published: public_recordings_test.py SETSQUARE NODE_FOLDER BAGS_FOLDER

Of every recording in the folder `setsquare convert` must give the scans that an independent reader
finds, with the same stamps, and odometry that agrees. The environment's SETSQUARE_BAGS_DIR names
another folder than the argument. Skips where it is absent.
"""
import os
import subprocess
import sys

import command_test_case
import comparison
import independent_readers

# Recordings whose messages contradict themselves in angles, so that a reader must choose.
ODD_ANGLES = ("own-scanner-bad-odometry.bag",)
# Recordings whose odometry is refused.
ODD_ODOMETRY = ("own-scanner-bad-odometry.bag",)
# Recordings that @foxglove/rosbag cannot read: the index is cut off.
UNREADABLE = ("truncated-no-laser.bag",)
SUFFIXES = (".bag", ".db3", ".mcap", ".mcap.zstd")


class PublicRecordingsTest(command_test_case.CommandTestCase):
    """Class attributes `readers` and `bags` are set by prepare()."""

    def convert(self, path):
        output = self.path("out.jsonl")
        command = [self.setsquare, "convert", "--sensor", "all", path, output]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        if ended.returncode != 0:
            return None, ended.stderr
        records = comparison.records_in(output)
        os.remove(output)
        return records, ""

    def test_scans_and_odometry_are_those_of_an_independent_reader(self):
        names = sorted(name for name in os.listdir(self.bags) if name.endswith(SUFFIXES))
        self.assertTrue(names)
        for name in names:
            if name in UNREADABLE:
                continue
            with self.subTest(recording=name):
                path = os.path.join(self.bags, name)
                lines = self.readers.lines_of(path)
                records, error = self.convert(path)
                if not any(line["kind"] == "scan" for line in lines):
                    self.assertIsNone(records, "scans where an independent reader finds none")
                    self.assertIn(name, error)
                    continue
                self.assertIsNotNone(records, error)
                comparison.compare_scans(records, lines, has_odd_angles=name in ODD_ANGLES)
                if name in ODD_ODOMETRY:
                    continue
                comparison.compare_stated_poses(records, lines)
                if comparison.odometry_lines(records, lines):
                    self.assertGreater(comparison.compare_odometry(records, lines), 0)


def prepare(test_case):
    test_case.bags = os.environ.get("SETSQUARE_BAGS_DIR", os.path.abspath(sys.argv[3]))
    if not os.path.isdir(test_case.bags):
        raise independent_readers.Missing(f"no folder {test_case.bags} (SETSQUARE_BAGS_DIR)")
    test_case.readers = independent_readers.Readers(sys.argv[2])


command_test_case.run(PublicRecordingsTest, sys.argv[1], prepare)
