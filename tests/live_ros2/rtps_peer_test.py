# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Live mapping heard by a node on a third implementation of RTPS (npm's @foxglove/rtps):
rtps_peer_test.py SETSQUARE NODE_FOLDER.
"""
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

SETSQUARE, NODE_FOLDER = sys.argv[1:3]
DOMAIN = "109"
SKIPPED = 77


def start(*command):
    return subprocess.Popen(command, cwd=NODE_FOLDER, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True)


def wait_for(program, words):
    for line in program.stdout:
        if words in line:
            return
    raise AssertionError(program.stderr.read())


class HeardByAnotherImplementation(unittest.TestCase):
    def test_all_that_is_published_is_understood(self):
        with tempfile.TemporaryDirectory() as folder:
            sim, bag = os.path.join(folder, "sim"), os.path.join(folder, "scans.mcap")
            for command in [["simulate", "--building", "corridor", "--no-people", "--beams", "180", "--rate", "5",
                             "-o", sim],
                            ["convert", os.path.join(sim, "scans.clf"), bag, "--from", "1", "--to", "40"]]:
                subprocess.run([SETSQUARE, *command], check=True, capture_output=True)
            live = start(SETSQUARE, "live", "--ros2", "--domain", DOMAIN, "--map-period", "0.5")
            wait_for(live, "waiting")
            peer = start("node", "rtps_peer.mjs", DOMAIN)
            wait_for(peer, "all are there")
            time.sleep(1.0)  # It is to be there for the other side, too.
            subprocess.run([SETSQUARE, "replay", bag, "--speed", "10", "--domain", DOMAIN], check=True,
                           capture_output=True, timeout=200)
            peer_told, peer_errors = peer.communicate(timeout=60)
            live.send_signal(signal.SIGTERM)
            told, errors = live.communicate(timeout=60)
        self.assertEqual(live.returncode, 0, errors)
        self.assertEqual(peer.returncode, 0, peer_errors)
        heard = json.loads(peer_told.splitlines()[-1])
        num_scans = int(re.search(r"^(\d+) scans, 0 lost", told, re.MULTILINE)[1])
        self.assertGreater(num_scans, 150)
        self.assertEqual(heard["num"]["rt/pose"], num_scans, heard)
        self.assertEqual(heard["num"]["rt/tf"], num_scans, heard)
        self.assertEqual(heard["frames"], [["map", "odom"]])
        self.assertGreater(heard["numFree"], 5000)
        self.assertGreater(heard["numOccupied"], 200)
        self.assertGreater(heard["numPoses"], 5)


if __name__ == "__main__":
    if shutil.which("node") is None:
        print("skipped: no node (tools/install_packages bags)")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
