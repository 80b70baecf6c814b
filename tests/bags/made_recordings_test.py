# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Recordings that the libraries of others write: made_recordings_test.py SETSQUARE NODE_FOLDER

One drive, written as ROS 1 bags, MCAP files and a ROS 2 folder, all packed in every way; `setsquare
convert` must give the scans, stamps, odometry and mounting that went in, and the same of each.
"""
import os
import sys

import command_test_case
import comparison
import independent_readers
import made_recording


class MadeRecordingsTest(command_test_case.CommandTestCase):
    """Class attribute `readers` is set by prepare()."""

    def convert(self, path):
        output = self.path("out.jsonl")
        self.run_setsquare("convert", "--sensor", "all", path, output)
        records = comparison.records_in(output)
        os.remove(output)
        return records

    def check(self, path):
        lines = made_recording.lines()
        self.assertEqual(len(self.readers.lines_of(path)), len(lines))  # the others read it too
        records = self.convert(path)
        comparison.compare_order(records)
        comparison.compare_scans(records, lines)
        comparison.compare_stated_poses(records, lines)
        num_with_odometry = comparison.compare_odometry(records, lines)
        self.assertEqual(num_with_odometry, made_recording.NUM_SCANS)
        comparison.compare_mounting(records, made_recording.MOUNTING)

    def test_ros1_bags(self):
        for compression in ("none", "bz2", "lz4"):
            with self.subTest(compression=compression):
                path = self.path(f"{compression}.bag")
                self.readers.write_rosbag1(compression, path, made_recording.lines())
                self.check(path)

    def test_mcap_files(self):
        for encoding in ("ros1", "cdr"):
            for compression in ("none", "lz4", "zstd"):
                with self.subTest(encoding=encoding, compression=compression):
                    path = self.path(f"{encoding}_{compression}.mcap")
                    self.readers.write_mcap(encoding, compression, path, made_recording.lines())
                    self.check(path)

    def test_a_folder_of_several_sqlite_files(self):
        path = self.path("drive")
        self.readers.write_sqlite_folder(path, made_recording.lines())
        self.check(path)


def prepare(test_case):
    test_case.readers = independent_readers.Readers(sys.argv[2])
    independent_readers.python_of_ros()


command_test_case.run(MadeRecordingsTest, sys.argv[1], prepare)
