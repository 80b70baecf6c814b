# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""A map and its making as an MCAP file: map_recording_test.py SETSQUARE NODE_FOLDER

What `setsquare convert LOG --map DIR OUT.mcap` writes is opened by @mcap/core through its index, as
viewers do: schemas parse, every message decodes, and scans, frames, path, grid and closures are
those of the map's own files.
"""
import json
import sys

import command_test_case
import independent_readers

TYPES = {
    "/scan": "sensor_msgs/msg/LaserScan",
    "/tf": "tf2_msgs/msg/TFMessage",
    "/tf_static": "tf2_msgs/msg/TFMessage",
    "/map": "nav_msgs/msg/OccupancyGrid",
    "/path": "nav_msgs/msg/Path",
    "/closures": "visualization_msgs/msg/MarkerArray",
}
POSITION_TOLERANCE_M = 1e-9


class MapRecordingTest(command_test_case.CommandTestCase):
    """Class attribute `readers` is set by prepare()."""

    @classmethod
    def setUpClass(cls):
        cls.run_setsquare("simulate", "--building", "office", "--every", "0.4", "--scanner",
                          "low-cost-360", "-o", cls.path("drive"))
        log = cls.path("drive/scans.clf")
        cls.run_setsquare("map", log, "-o", cls.path("map"))
        cls.run_setsquare("convert", log, "--map", cls.path("map"), cls.path("map.mcap"))
        cls.topics = {line["topic"]: line for line in cls.readers.topics_of(cls.path("map.mcap"))}
        cls.poses = command_test_case.poses_in(cls.path("map/trajectory.tum"))

    def last(self, topic):
        return self.topics[topic]["last"]

    def assert_is_last_position(self, position):
        for name, expected in zip("xy", self.poses[-1][1:]):
            self.assertAlmostEqual(position[name], expected, delta=POSITION_TOLERANCE_M)

    def test_topics_have_the_types_that_viewers_show(self):
        self.assertEqual({name: line["type"] for name, line in self.topics.items()}, TYPES)
        for name, line in self.topics.items():
            self.assertTrue(line["stamps_ascend"], name)

    def test_every_scan_has_its_frame(self):
        self.assertEqual(self.topics["/scan"]["num"], len(self.poses))
        self.assertEqual(self.topics["/tf"]["num"], len(self.poses))
        transform = self.last("/tf")["transforms"][0]
        self.assertEqual(transform["header"]["frame_id"], "map")
        self.assert_is_last_position(transform["transform"]["translation"])
        mounting = self.last("/tf_static")["transforms"][0]
        self.assertEqual(mounting["header"]["frame_id"], transform["child_frame_id"])
        self.assertEqual(mounting["child_frame_id"], self.last("/scan")["header"]["frame_id"])
        self.assertEqual(self.last("/scan")["header"]["stamp"], transform["header"]["stamp"])

    def test_the_path_ends_where_the_trajectory_does(self):
        path = self.last("/path")
        self.assertEqual(path["header"]["frame_id"], "map")
        self.assert_is_last_position(path["poses"][-1]["pose"]["position"])
        self.assertGreater(len(path["poses"]), len(self.poses) // 4)

    def test_the_grid_covers_the_map(self):
        grid = self.last("/map")
        info = grid["info"]
        self.assertGreater(self.topics["/map"]["num"], 10, "it grows")
        self.assertEqual(grid["data"]["length"], info["width"] * info["height"])
        self.assertGreater(grid["data"]["sum"], 0)
        for name, size, coordinates in (("x", info["width"], [pose[1] for pose in self.poses]),
                                        ("y", info["height"], [pose[2] for pose in self.poses])):
            begin = info["origin"]["position"][name]
            self.assertLess(begin, min(coordinates))
            self.assertGreater(begin + size * info["resolution"], max(coordinates))

    def test_closures_are_lines_between_two_poses(self):
        with open(self.path("map/run.json"), encoding="utf-8") as run:
            num_closures = json.load(run)["closures"]["accepted"]
        self.assertGreater(num_closures, 0)
        points = sum(len(marker["points"]) for marker in self.last("/closures")["markers"])
        self.assertEqual(points, 2 * num_closures)


def prepare(test_case):
    test_case.readers = independent_readers.Readers(sys.argv[2])


command_test_case.run(MapRecordingTest, sys.argv[1], prepare)
