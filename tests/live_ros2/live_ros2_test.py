# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Live mapping beside a robot on Cyclone DDS, which shares no code with Setsquare:
live_ros2_test.py SETSQUARE ROBOT_PEER FLOOD_PEER.

Domains are those from 100 up that no other test of this machine uses; everything stays on the
loopback device.
"""
import atexit
import glob
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

SETSQUARE = sys.argv[1]
PEER = sys.argv[2]
FLOOD = sys.argv[3]
NUM_SCANS = 150

# As a node of ROS 2 under ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST and rmw_cyclonedds_cpp has it.
LOCALHOST = """<CycloneDDS><Domain>
<General><Interfaces><NetworkInterface address="127.0.0.1"/></Interfaces>
<AllowMulticast>false</AllowMulticast></General>
<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>
<Peers><Peer address="127.0.0.1"/></Peers></Discovery></Domain></CycloneDDS>"""


def start_live(domain, *options):
    live = subprocess.Popen(
        [SETSQUARE, "live", "--ros2", "--domain", str(domain), *options],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        errors="replace")  # it names what damaged messages name
    atexit.register(live.kill)  # of a test that failed; else it has ended
    for line in live.stdout:
        if "waiting" in line:
            return live
    raise AssertionError(live.stderr.read())


def stop(live):
    live.send_signal(signal.SIGTERM)
    out, err = live.communicate(timeout=120)
    return live.returncode, out, err


def drive(domain, num_scans, period_ms, *options):
    environment = dict(os.environ, CYCLONEDDS_URI=LOCALHOST)
    peer = subprocess.run([PEER, str(domain), str(num_scans), str(period_ms), *options], text=True,
                          capture_output=True, timeout=300, env=environment, check=False)
    assert peer.returncode == 0, peer.stderr
    return peer.stdout


def kept_files(folder):
    return set(glob.glob(os.path.join(folder, "*.mcap")))


def wait_for_new_files(folder, num_files, replay):
    before = kept_files(folder)
    while len(kept_files(folder) - before) < num_files:
        assert replay.poll() is None, "the log ended before the kill"
        time.sleep(0.05)


def numbers(heard, name):
    found = re.search(rf"^{name} (.*)$", heard, re.MULTILINE)
    assert found, f"{name} is not in:\n{heard}"
    return [float(word) for word in found[1].split()]


class BesideARobot(unittest.TestCase):
    """One drive; what the robot heard, and what live mapping left."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = os.path.join(cls.folder.name, "out")
        live = start_live(101, "-o", cls.out, "--slam-toolbox-names")
        cls.heard = drive(101, NUM_SCANS, 30, "slam_toolbox", "say")
        cls.returncode, cls.told, cls.errors = stop(live)
        live = start_live(108, "--localize", cls.out, "-o", os.path.join(cls.folder.name, "where"))
        cls.heard_in_map = drive(108, NUM_SCANS, 30, "say")
        cls.localised = stop(live)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_scan_is_mapped(self):
        self.assertEqual(self.returncode, 0, self.errors)
        self.assertIn(f"{NUM_SCANS} scans, 0 lost", self.told)

    def test_poses_and_transforms_come_with_the_stamps_of_the_scans(self):
        self.assertEqual(numbers(self.heard, "tf"), [NUM_SCANS])
        self.assertEqual(numbers(self.heard, "tf_with_stamp"), [NUM_SCANS])
        self.assertEqual(numbers(self.heard, "poses"), [NUM_SCANS])
        self.assertGreater(numbers(self.heard, "covariance")[0], 0.0)

    def test_the_pose_is_where_the_robot_is(self):
        truth, pose = numbers(self.heard, "truth")[0], numbers(self.heard, "pose")[0]
        self.assertLess(abs(truth - pose), 0.05)

    def test_the_map_is_the_room(self):
        width, height, free, occupied = numbers(self.heard, "map")
        self.assertTrue(80 < width < 400 and 80 < height < 400, self.heard)
        self.assertGreater(free, 5000)
        self.assertGreater(occupied, 200)

    def test_one_who_comes_late_gets_the_map(self):
        self.assertGreaterEqual(numbers(self.heard, "late_maps")[0], 1)

    def test_services_answer(self):
        self.assertNotIn("unanswered", self.heard)
        self.assertIn("save_map 1 written", self.heard)
        self.assertGreater(numbers(self.heard, "get_map")[2], 5000)
        self.assertIn("pause 1 paused", self.heard)

    def test_a_map_is_saved_below_the_output_folder_and_nowhere_else(self):
        self.assertIn("slam_toolbox save_map 0", self.heard)
        self.assertTrue(os.path.exists(os.path.join(self.out, "by_name", "map.yaml")))
        self.assertIn("slam_toolbox save_map elsewhere 255", self.heard)
        self.assertFalse(os.path.exists(os.path.join(self.folder.name, "elsewhere")))

    def test_the_map_is_written_at_the_end(self):
        self.assertTrue(os.path.exists(os.path.join(self.out, "map.yaml")))
        with open(os.path.join(self.out, "trajectory.tum"), encoding="ascii") as file:
            poses = [line for line in file if not line.startswith("#")]
        self.assertEqual(len(poses), NUM_SCANS)


    def test_in_the_map_it_is_found_and_followed_whatever_is_said(self):
        returncode, told, errors = self.localised
        self.assertEqual(returncode, 0, errors)
        heard = self.heard_in_map
        self.assertIn("said to 1", heard)
        # No pose and no map -> odom before it is localised; then both with each scan's stamp.
        poses = numbers(heard, "poses")[0]
        self.assertTrue(NUM_SCANS / 2 < poses < NUM_SCANS, heard)
        self.assertEqual(numbers(heard, "tf_with_stamp"), [poses])
        self.assertEqual(numbers(heard, "map"), numbers(self.heard, "get_map"))
        self.assertRegex(heard, "diagnostic 0 setsquare: localisation: localised")
        self.assertIn("save_map 0", heard)
        # Where it says that it is does not hold against the scans.
        with open(os.path.join(self.folder.name, "where", "trajectory.tum"), encoding="ascii") as file:
            last = [float(word) for word in file.readlines()[-1].split()]
        with open(os.path.join(self.out, "trajectory.tum"), encoding="ascii") as file:
            mapped = [float(word) for word in file.readlines()[-1].split()]
        self.assertLess(abs(last[1] - mapped[1]) + abs(last[2] - mapped[2]), 0.06)

    def test_a_pose_that_is_said_while_a_map_is_made_is_refused_once(self):
        self.assertIn("said to 1", self.heard)
        self.assertEqual(self.errors.count("a pose has no meaning while a map is made"), 1)


class BesideOurOwnReplay(unittest.TestCase):
    def test_a_log_over_the_wire_gives_the_map_of_the_log(self):
        with tempfile.TemporaryDirectory() as folder:
            sim = os.path.join(folder, "sim")
            subprocess.run([SETSQUARE, "simulate", "--building", "corridor", "--no-people", "--beams",
                            "180", "--rate", "5", "-o", sim], check=True, capture_output=True)
            log = os.path.join(sim, "scans.clf")
            bag = os.path.join(folder, "scans.mcap")  # float32, as messages have it
            # A stamp of 0 is none on the wire.
            subprocess.run([SETSQUARE, "convert", log, bag, "--from", "1"], check=True,
                           capture_output=True)
            subprocess.run([SETSQUARE, "map", bag, "-o", os.path.join(folder, "map")], check=True,
                           capture_output=True)
            live = start_live(102, "-o", os.path.join(folder, "live"))
            subprocess.run([SETSQUARE, "replay", bag, "--speed", "10", "--domain", "102"], check=True,
                           capture_output=True, timeout=300)
            time.sleep(1.0)
            returncode, told, errors = stop(live)
            self.assertEqual(returncode, 0, errors)
            for name in ["trajectory.tum", "map.pgm", "map.yaml"]:
                with open(os.path.join(folder, "map", name), "rb") as file:
                    mapped = file.read()
                with open(os.path.join(folder, "live", name), "rb") as file:
                    self.assertEqual(file.read(), mapped, f"{name}\n{told}")


def run(*command):
    subprocess.run([SETSQUARE, *command], check=True, capture_output=True)


def resident_kb(pid):
    with open(f"/proc/{pid}/status", encoding="ascii") as file:
        return int(re.search(r"VmRSS:\s+(\d+)", file.read())[1])


def poses_of(folder):
    """Of the trajectory: x and y by the stamp."""
    with open(os.path.join(folder, "trajectory.tum"), encoding="ascii") as file:
        rows = [line.split() for line in file if not line.startswith("#")]
    return {row[0]: (float(row[1]), float(row[2])) for row in rows}


class WhatGoesWrong(unittest.TestCase):
    def test_a_flood_of_damaged_messages_and_lies_changes_nothing(self):
        seed = int(os.environ.get("SETSQUARE_TEST_SEED", "20141018"))
        print("seed", seed)
        with tempfile.TemporaryDirectory() as folder:
            sim, bag = os.path.join(folder, "sim"), os.path.join(folder, "scans.mcap")
            run("simulate", "--building", "corridor", "--no-people", "--beams", "180", "--rate", "5", "-o", sim)
            run("convert", os.path.join(sim, "scans.clf"), bag, "--from", "1", "--to", "70")
            run("map", bag, "-o", os.path.join(folder, "map"))
            kept = os.path.join(folder, "kept")
            live = start_live(105, "-o", os.path.join(folder, "live"), "--state", kept, "--state-period", "0.2")
            replay = subprocess.Popen([SETSQUARE, "replay", bag, "--speed", "10", "--domain", "105"],
                                      stdout=subprocess.DEVNULL)
            wait_for_new_files(kept, 10, replay)  # The robot is known: 2 s or so.
            before_kb = resident_kb(live.pid)
            flood = subprocess.run([FLOOD, "105", "1000", str(seed)], capture_output=True, text=True,
                                   timeout=120, check=True)
            self.assertIn("1000 of each", flood.stdout)
            self.assertLess(resident_kb(live.pid) - before_kb, 100_000)
            self.assertIsNone(replay.poll(), "the log ended before the flood")
            self.assertEqual(replay.wait(timeout=200), 0)
            time.sleep(1.0)
            returncode, told, errors = stop(live)
            self.assertEqual(returncode, 0, errors)
            without, flooded = [poses_of(os.path.join(folder, name)) for name in ("map", "live")]
        # Readers of scans keep five: of a flood some of the robot's own may go.
        self.assertGreater(len(flooded), 0.9 * len(without), told)
        self.assertTrue(set(flooded) <= set(without), "scans of the broken node are mapped")
        for stamp, (x_m, y_m) in flooded.items():
            self.assertLess(abs(x_m - without[stamp][0]) + abs(y_m - without[stamp][1]), 0.1, stamp)
        # Each is counted and told: of the transforms by reasons, of scans and odometry by who spoke.
        for topic in ["/tf", "/tf_static"]:
            left_out = re.search(rf"{topic}: (\d+) left out: ", errors)
            self.assertTrue(left_out, errors)
            self.assertGreater(int(left_out[1]), 600)
        for topic in ["/scan", "/odom"]:
            others = re.search(rf"{topic} is published by several nodes: (\d+) messages", told)
            self.assertTrue(others, told)
        self.assertRegex(told, r"/initialpose: \d\d+ messages left out")
        self.assertRegex(told, r"\d+ messages left out: damaged")

    def test_a_run_that_was_killed_goes_on(self):
        with tempfile.TemporaryDirectory() as folder:
            sim, bag = os.path.join(folder, "sim"), os.path.join(folder, "scans.mcap")
            subprocess.run([SETSQUARE, "simulate", "--building", "corridor", "--no-people", "--beams",
                            "180", "--rate", "5", "-o", sim], check=True, capture_output=True)
            subprocess.run([SETSQUARE, "convert", os.path.join(sim, "scans.clf"), bag, "--from", "1"],
                           check=True, capture_output=True)
            options = ["--state", os.path.join(folder, "kept"), "--state-period", "0.5", "-o",
                       os.path.join(folder, "live")]
            live = start_live(106, *options)
            # Of 130 s of log, in 32 s. A kill waits for what this run has kept, not for a time: a
            # machine may start programs slowly.
            replay = subprocess.Popen([SETSQUARE, "replay", bag, "--speed", "4", "--domain", "106"],
                                      stdout=subprocess.DEVNULL)
            for _ in range(3):
                wait_for_new_files(os.path.join(folder, "kept"), 4, replay)
                live.kill()
                live.communicate()
                live = start_live(106, *options)
            self.assertEqual(replay.wait(timeout=200), 0)
            time.sleep(1.0)
            returncode, told, errors = stop(live)
            self.assertEqual(returncode, 0, errors)
            with open(os.path.join(folder, "live", "trajectory.tum"), encoding="ascii") as file:
                stamps = [float(line.split()[0]) for line in file if not line.startswith("#")]
            # Every run's part is there: the first begins the log, the last ends it, and what is missing
            # is what came within half a second before a kill and while a program started. That is
            # little or nothing, by chance; here four times as much of the log's time.
            self.assertLess(stamps[0], 3.0)
            self.assertGreater(stamps[-1], 120.0)
            gaps = [b - a for a, b in zip(stamps, stamps[1:])]
            self.assertGreater(min(gaps), 0.0)
            self.assertLess(sum(gap for gap in gaps if gap > 1.0), 60.0, told)


class Alone(unittest.TestCase):
    def test_parameters_come_from_a_file_of_ros_2(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "setsquare.yaml")
            with open(path, "w", encoding="ascii") as file:
                file.write("/robot:\n  slam_toolbox:\n    ros__parameters:\n"
                           "      scan_topic: front/scan\n      solver_plugin: x\n")
            live = subprocess.Popen(
                [SETSQUARE, "live", "--ros2", "--domain", "107", "--params-file", path],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.assertEqual(live.stdout.readline(), "waiting for scans on /front/scan\n")
            _, _, errors = stop(live)
            self.assertIn("without a meaning here: solver_plugin", errors)

    def test_the_modes_of_slam_toolbox_have_their_meaning(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "setsquare.yaml")
            for mode, needed in [("localization", "nowhere.yaml"), ("mapping", "nowhere")]:
                with open(path, "w", encoding="ascii") as file:
                    file.write("slam_toolbox:\n  ros__parameters:\n"
                               f"    mode: {mode}\n    map_file_name: {folder}/{needed}\n"
                               "    map_start_pose: [1.0, 2.0, 1.57]\n")
                live = subprocess.run([SETSQUARE, "live", "--ros2", "--domain", "107", "--params-file",
                                       path], capture_output=True, text=True, timeout=60, check=False)
                self.assertEqual(live.returncode, 2)
                self.assertIn(f"{folder}/{needed}", live.stderr)  # the map that is looked for
                self.assertNotIn("without a meaning", live.stderr)

    def test_without_a_scan_it_says_so(self):
        live = start_live(103)
        returncode, _, errors = stop(live)
        self.assertEqual(returncode, 2)
        self.assertIn("no scan", errors)

    def test_it_listens_on_the_loopback_device_alone(self):
        live = start_live(104)
        inodes = set()
        for entry in os.listdir(f"/proc/{live.pid}/fd"):
            try:
                target = os.readlink(f"/proc/{live.pid}/fd/{entry}")
            except OSError:
                continue
            if target.startswith("socket:["):
                inodes.add(target[8:-1])
        addresses = []
        for table in ["udp", "udp6", "tcp", "tcp6"]:
            with open(f"/proc/{live.pid}/net/{table}", encoding="ascii") as file:
                for line in list(file)[1:]:
                    fields = line.split()
                    if fields[9] in inodes:
                        addresses.append(fields[1].split(":")[0])
        stop(live)
        self.assertTrue(addresses)
        loopback, multicast = "0100007F", "0100FFEF"  # 127.0.0.1, 239.255.0.1
        self.assertEqual(set(addresses) - {loopback, multicast}, set())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
