# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""What the readers and writers of others make of recordings, as lines of made_recording.py.

ROS 1 bags are written by ROS's own library for Python (python3-rosbag) and read by npm's
@foxglove/rosbag; MCAP files are written and read by @mcap/core; what SQLite files hold is listed by
Python's sqlite3; CDR is written and read by @foxglove/rosmsg2-serialization.
"""
import functools
import json
import os
import shutil
import subprocess
import sys

import sqlite_recording

SKIPPED = 77  # the exit code that CTest takes for a skipped test
HERE = os.path.dirname(os.path.abspath(__file__))


class Missing(Exception):
    """Something that the tests need is not on this machine."""


@functools.lru_cache
def python_of_ros():
    """A Python that has ROS 1's library: Debian's, which need not be the first on the path."""
    for python in (sys.executable, "/usr/bin/python3"):
        found = subprocess.run([python, "-c", "import rosbag, nav_msgs.msg, sensor_msgs.msg, tf2_msgs.msg"],
                               capture_output=True, check=False)
        if found.returncode == 0:
            return python
    raise Missing("no python3-rosbag with its messages (tools/install_packages bags)")


def run(command, text=None):
    ended = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: {ended.stderr[-2000:]}")
    return ended.stdout


def text_of(lines):
    return "".join(json.dumps(line) + "\n" for line in lines)


def lines_in(text):
    return [json.loads(line) for line in text.splitlines()]


class Readers:
    """Runs the programs in this folder; `node_folder` holds copies of those for Node, beside the
    packages that they need."""

    def __init__(self, node_folder):
        self.node_folder = node_folder
        if shutil.which("node") is None:
            raise Missing("no node (tools/install_packages bags)")
        if not os.path.isdir(os.path.join(node_folder, "node_modules", "@mcap")):
            raise Missing(f"no packages of npm in {node_folder} (the test bags.npm_packages gets them)")

    def node(self, program, *arguments, lines=None):
        command = ["node", os.path.join(self.node_folder, program), *arguments]
        return run(command, None if lines is None else text_of(lines))

    def write_rosbag1(self, compression, path, lines):
        program = os.path.join(HERE, "write_rosbag1.py")
        run([python_of_ros(), "-B", program, compression, path], text_of(lines))

    def write_mcap(self, encoding, compression, path, lines):
        self.node("write_mcap.mjs", encoding, compression, path, lines=lines)

    def write_sqlite_folder(self, folder, lines):
        messages = lines_in(self.node("write_cdr.mjs", lines=lines))
        sqlite_recording.write_folder(folder, messages)

    def topics_of(self, path):
        """A line for each topic of an MCAP file, all of whose messages are decoded."""
        return lines_in(self.node("describe_mcap.mjs", path))

    def lines_of(self, path):
        """All that a recording holds; of a folder, that of its SQLite files."""
        if os.path.isdir(path):
            files = sorted(name for name in os.listdir(path) if name.endswith(".db3"))
            return [line for name in files for line in self.lines_of(os.path.join(path, name))]
        with open(path, "rb") as file:
            beginning = file.read(16)
        if beginning.startswith(b"SQLite"):
            return lines_in(self.node("dump_cdr.mjs", lines=sqlite_recording.messages_in(path)))
        is_bag = beginning.startswith(b"#ROSBAG")
        return lines_in(self.node("dump_rosbag1.mjs" if is_bag else "dump_mcap.mjs", path))
