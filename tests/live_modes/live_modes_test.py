# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""`setsquare live` on a log gives the files of `setsquare localize`, and those of
`setsquare map --continue`, byte by byte: live_modes_test.py SETSQUARE.
"""
import os
import subprocess
import sys
import tempfile
import unittest

SETSQUARE = sys.argv[1]


def run(*command, exit_code=0):
    ended = subprocess.run([SETSQUARE, *command], capture_output=True, text=True, timeout=200, check=False)
    assert ended.returncode == exit_code, f"{command}: {ended.stdout}\n{ended.stderr}"
    return ended


def read(*names):
    with open(os.path.join(*names), "rb") as file:
        return file.read()


class Modes(unittest.TestCase):
    """A robot in a made-up office on two days: the map of the first, and the log of the second."""

    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = cls.holder.name
        run("simulate", "--building", "office", "--seed", "5", "--every", "0.3", "-o", cls.path("sim"))
        cls.log = cls.path("sim", "scans.clf")
        run("map", cls.log, "-o", cls.path("monday"))

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    @classmethod
    def path(cls, *names):
        return os.path.join(cls.folder, *names)

    def assert_same_files(self, a, b, but=()):
        names = sorted(set(os.listdir(a)) - set(but))
        self.assertEqual(names, sorted(set(os.listdir(b)) - set(but)))
        for name in names:
            if os.path.isfile(os.path.join(a, name)):
                self.assertEqual(read(a, name), read(b, name), name)

    def test_localised_live_is_localised(self):
        for name, of_command, of_live in [("free", [], []), ("said", ["--start", "1,2,30"], ["--start", "1,2,30"]),
                                          ("alone", ["--no-odometry"], ["--no-odometry"])]:
            run("localize", self.path("monday"), self.log, "-o", self.path(name), *of_command)
            told = run("live", "--replay", self.log, "--speed", "0", "--localize", self.path("monday"), "-o",
                       self.path(name + "_live"), *of_live).stdout
            self.assert_same_files(self.path(name), self.path(name + "_live"))
            self.assertIn("localised", told)

    def test_any_programs_map_will_do(self):
        run("localize", self.path("monday", "map.yaml"), self.log, "-o", self.path("yaml"))
        run("live", "--replay", self.log, "--speed", "0", "--localize", self.path("monday", "map.yaml"),
            "-o", self.path("yaml_live"))
        self.assert_same_files(self.path("yaml"), self.path("yaml_live"))

    def test_continued_live_is_continued(self):
        run("map", self.log, "--no-odometry", "--continue", self.path("monday"), "-o", self.path("both"),
            "--threads", "1")
        told = run("live", "--replay", self.log, "--no-odometry", "--speed", "0", "--continue",
                   self.path("monday"), "-o", self.path("both_live")).stdout
        self.assert_same_files(self.path("both"), self.path("both_live"), but=("timing.json",))
        self.assertIn("session 2 of 2", told)

    def test_what_cannot_be_is_refused(self):
        refused = run("live", "--replay", self.log, "--continue", self.path("monday"), "-o",
                      self.path("monday"), exit_code=2)
        self.assertIn("it is the file that is read", refused.stderr)
        for options in (["--localize", "a", "--continue", "b"], ["--localize", "a", "--state", "b"],
                        ["--start", "1,2,3"]):
            ended = subprocess.run([SETSQUARE, "live", "--replay", self.log, *options], capture_output=True,
                                   text=True, timeout=60, check=False)
            self.assertNotEqual(ended.returncode, 0, options)
        missing = run("live", "--replay", self.log, "--localize", self.path("nowhere"), exit_code=2)
        self.assertIn("nowhere", missing.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
