# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""One log in every container: one_log_test.py SETSQUARE NODE_FOLDER DATA_FOLDER [NUM_SCANS]

The beginning of a real log (intel) as `setsquare convert` writes it, and as the libraries of others
write bags of it: `setsquare map` must make the same map of each, byte by byte, and the same
trajectory but for what a quaternion rounds. The environment's SETSQUARE_DATA_DIR names another
folder than the argument. Skips where it is absent.
"""
import os
import sys

import carmen_lines
import command_test_case
import independent_readers

NUM_SCANS = 500
TRAJECTORY_DIGIT = 1e-6  # of the numbers in a trajectory


class OneLogTest(command_test_case.CommandTestCase):
    """Class attributes `readers` and `log` are set by prepare()."""

    @classmethod
    def setUpClass(cls):
        cls.image, cls.poses = cls.map_of(cls.log)
        with open(cls.log, encoding="ascii") as log:
            cls.lines = carmen_lines.lines_in(log)

    @classmethod
    def map_of(cls, log):
        cls.run_setsquare("map", log, "-o", cls.path("out"))
        with open(cls.path("out/map.pgm"), "rb") as image:
            pixels = image.read()
        return pixels, command_test_case.poses_in(cls.path("out/trajectory.tum"))

    def check_map(self, log):
        image, poses = self.map_of(log)
        self.assertEqual(len(poses), len(self.poses))
        difference = max(abs(a - b) for pose, expected in zip(poses, self.poses)
                         for a, b in zip(pose, expected))
        self.assertLess(difference, 1.5 * TRAJECTORY_DIGIT)
        self.assertEqual(image, self.image, "another map")

    def test_formats_that_convert_writes(self):
        # Not carmen, which holds scans to the millimetre.
        for suffix in ("csv", "jsonl", "mcap"):
            with self.subTest(suffix):
                path = self.path(f"converted.{suffix}")
                self.run_setsquare("convert", self.log, path)
                self.check_map(path)

    def test_a_ros1_bag(self):
        self.readers.write_rosbag1("lz4", self.path("log.bag"), self.lines)
        self.check_map(self.path("log.bag"))

    def test_a_folder_of_sqlite_files(self):
        self.readers.write_sqlite_folder(self.path("log"), self.lines)
        self.check_map(self.path("log"))


def prepare(test_case):
    node_folder, data = sys.argv[2:4]
    num_scans = int(sys.argv[4]) if len(sys.argv) > 4 else NUM_SCANS
    log = os.path.join(os.environ.get("SETSQUARE_DATA_DIR", data), "intel", "intel.clf")
    if not os.path.isfile(log):
        raise independent_readers.Missing(f"no file {log} (SETSQUARE_DATA_DIR)")
    test_case.readers = independent_readers.Readers(node_folder)
    independent_readers.python_of_ros()
    test_case.log = test_case.path("log.clf")
    with open(test_case.log, "w", encoding="ascii") as beginning:
        beginning.writelines(carmen_lines.beginning_of(log, num_scans))


command_test_case.run(OneLogTest, sys.argv[1], prepare)
