# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""What the tests of the built command share: running it in a folder of their own."""
import os
import subprocess
import sys
import tempfile
import unittest

import independent_readers


class CommandTestCase(unittest.TestCase):
    """Class attributes `setsquare` and `folder` are set by run(), `readers` by its `prepare`."""

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name)

    @classmethod
    def run_setsquare(cls, *arguments):
        ended = subprocess.run([cls.setsquare, *arguments], capture_output=True, text=True,
                               check=False)
        if ended.returncode != 0:
            raise AssertionError(f"{arguments}: {ended.stderr}")


def poses_in(path):
    """The rows of a trajectory: stamp, position, orientation."""
    with open(path, encoding="ascii") as trajectory:
        return [[float(word) for word in line.split()] for line in trajectory]


def run(test_case, setsquare, prepare):
    """Runs the tests of the program in a folder that is removed afterwards. Skips where
    `prepare(test_case)` raises Missing."""
    test_case.setsquare = os.path.abspath(setsquare)
    with tempfile.TemporaryDirectory() as folder:
        test_case.folder = folder
        try:
            prepare(test_case)
        except independent_readers.Missing as missing:
            print(f"skipped: {missing}")
            sys.exit(independent_readers.SKIPPED)
        unittest.main(argv=sys.argv[:1], verbosity=2)
