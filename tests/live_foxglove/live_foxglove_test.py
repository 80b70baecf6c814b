# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Live mapping shown to, and taken from, programs of others that speak the Foxglove protocol:
live_foxglove_test.py SETSQUARE NODE_FOLDER.
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

SETSQUARE = sys.argv[1]
NODE_FOLDER = sys.argv[2]


def run(*command, **options):
    ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300,
                           check=False, **options)
    assert ended.returncode == 0, f"{command}: {ended.stdout}\n{ended.stderr}"
    return ended.stdout


def run_node(script, *arguments):
    return run("node", os.path.join(NODE_FOLDER, script), *arguments)


class WithFoxglove(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.log = os.path.join(cls.folder.name, "sim", "scans.clf")
        run(SETSQUARE, "simulate", "--building", "office", "--no-people", "--beams", "180", "--rate",
            "5", "-o", os.path.dirname(cls.log))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def path(self, *names):
        return os.path.join(self.folder.name, *names)

    def test_a_viewer_sees_scans_map_path_and_closures(self):
        live = subprocess.Popen(
            [SETSQUARE, "live", "--replay", self.log, "--speed", "10", "--foxglove",
             "--foxglove-port", "0"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        port = re.search(r":(\d+)$", live.stdout.readline().strip())[1]
        lines = run_node("view_live.mjs", port, 100).splitlines()
        live.send_signal(signal.SIGTERM)
        told, errors = live.communicate(timeout=120)
        self.assertEqual(live.returncode, 0, errors + told)
        self.assertEqual(json.loads(lines[0])["name"], "setsquare")
        seen = json.loads(lines[1])
        self.assertEqual(seen["frames"][:2], [["map", "odom"], ["odom", "base_link"]])
        self.assertEqual(seen["frames"][2][0], "base_link")
        self.assertEqual(seen["numBeams"], 180)
        self.assertTrue(seen["stampAgrees"])
        self.assertGreater(seen["numFree"], 1000)
        self.assertGreater(seen["numOccupied"], 100)
        self.assertGreater(seen["numPoses"], 2)
        self.assertEqual(seen["numMarkers"], 1)

    def test_scans_from_a_bridge_give_the_map_of_the_log(self):
        bag = self.path("scans.mcap")
        run(SETSQUARE, "convert", self.log, bag, "--from", "1")  # A stamp of 0 is none on the wire.
        run(SETSQUARE, "map", bag, "-o", self.path("map"))
        bridge = subprocess.Popen(["node", os.path.join(NODE_FOLDER, "bridge.mjs"), bag, "600"],
                                  stdout=subprocess.PIPE, text=True)
        port = bridge.stdout.readline().strip()
        live = subprocess.Popen([SETSQUARE, "live", "--from", f"ws://127.0.0.1:{port}", "-o",
                                 self.path("live")], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True)
        self.assertEqual(bridge.wait(timeout=200), 0)
        time.sleep(1.0)
        live.send_signal(signal.SIGTERM)
        told, errors = live.communicate(timeout=120)
        self.assertEqual(live.returncode, 0, errors + told)
        self.assertIn("connected", errors)
        for name in ["trajectory.tum", "map.pgm", "map.yaml"]:
            with open(self.path("map", name), "rb") as file:
                mapped = file.read()
            with open(self.path("live", name), "rb") as file:
                self.assertEqual(file.read(), mapped, f"{name}\n{told}")


if __name__ == "__main__":
    if shutil.which("node") is None:
        print("skipped: no node (tools/install_packages bags)")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
