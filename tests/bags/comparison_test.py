# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""The comparison sees every kind of difference; without it the tests beside would prove nothing."""
import copy
import decimal
import unittest

import comparison
import made_recording


def json_number(value):
    return None if value == "nan" else value


def records_of(lines):
    """What setsquare should write of a recording."""
    records = []
    poses = {line["stamp_ns"]: [line["x"], line["y"], line["yaw"]]
             for line in lines if line["kind"] == "odometry"}
    for line in lines:
        if line["kind"] == "transform":
            continue
        stamp = decimal.Decimal(line["stamp_ns"]) / 1_000_000_000
        record = {"stamp": stamp, "sensor": line["topic"], "odometry": poses[line["stamp_ns"]]}
        if line["kind"] == "scan":
            record["angle_min"] = line["angle_min"]
            record["angle_step"] = line["angle_increment"]
            record["mounting"] = list(made_recording.MOUNTING)
            record["ranges"] = [json_number(value) for value in line["ranges"]]
        records.append(record)
    return records


class ComparisonTest(unittest.TestCase):
    def setUp(self):
        self.lines = made_recording.lines()
        self.records = records_of(self.lines)
        self.scans = [record for record in self.records if "ranges" in record]

    def compare(self, records):
        comparison.compare_order(records)
        comparison.compare_scans(records, self.lines)
        comparison.compare_stated_poses(records, self.lines)
        comparison.compare_odometry(records, self.lines)
        comparison.compare_mounting(records, made_recording.MOUNTING)

    def test_the_same_is_the_same(self):
        self.compare(self.records)
        self.assertEqual(comparison.compare_odometry(self.scans, self.lines), len(self.scans))

    def test_the_name_of_a_frame_means_its_topic(self):
        for scan in self.scans:
            scan["sensor"] = "laser"
        self.compare(self.records)

    def test_odometry_between_two_messages_may_be_anywhere_between(self):
        self.scans[3]["stamp"] += decimal.Decimal("0.01")
        pose = self.scans[3]["odometry"]
        self.scans[3]["odometry"] = [pose[0] + 0.005, pose[1] + 0.001, pose[2] + 0.0025]
        comparison.compare_odometry(self.records, self.lines)

    def test_every_difference_is_seen(self):
        def change(name, value):
            return lambda scan: scan.update({name: value(scan[name])})

        changes = {
            "stamp": change("stamp", lambda stamp: stamp + decimal.Decimal("1e-9")),
            "angle_min": change("angle_min", lambda angle: angle + 1e-4),
            "angle_step": change("angle_step", lambda angle: -angle),
            "odometry": change("odometry", lambda pose: [pose[0] + 0.01, pose[1], pose[2]]),
            "mounting": change("mounting", lambda pose: [pose[0], -pose[1], pose[2]]),
            "a range": lambda scan: scan["ranges"].__setitem__(100, 1.0),
            "no return": lambda scan: scan.update(ranges=[None] * len(scan["ranges"])),
            "a beam less": lambda scan: scan["ranges"].pop(),
            "no ranges": lambda scan: scan.pop("ranges"),
        }
        for name, apply in changes.items():
            with self.subTest(name):
                records = copy.deepcopy(self.records)
                apply([record for record in records if "ranges" in record][7])
                with self.assertRaises(comparison.Difference):
                    self.compare(records)

    def test_a_pose_between_scans_that_differs_is_seen(self):
        pose = next(record for record in self.records if "ranges" not in record)
        pose["odometry"] = [pose["odometry"][0], pose["odometry"][1] + 1e-6, pose["odometry"][2]]
        with self.assertRaises(comparison.Difference):
            self.compare(self.records)

    def test_another_order_is_seen(self):
        with self.assertRaises(comparison.Difference):
            self.compare(self.records[::-1])

    def test_a_scan_more_or_less_is_seen(self):
        with self.assertRaises(comparison.Difference):
            self.compare(self.records + self.scans[-1:])
        with self.assertRaises(comparison.Difference):
            self.compare([record for record in self.records if record is not self.scans[0]])


if __name__ == "__main__":
    unittest.main()
