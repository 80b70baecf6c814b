# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""The view of live mapping, in a headless Chromium and by what no browser sends:
live_view_test.py SETSQUARE.

A robot drives through a made-up office, faster than a real one.
"""
import base64
import json
import os
import random
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

import chromium
from png_pixels import Picture, distance

SETSQUARE = sys.argv[1]
SEED = int(os.environ.get("SETSQUARE_TEST_SEED", "20141018"))


def run(*command):
    ended = subprocess.run([SETSQUARE, *command], capture_output=True, text=True, timeout=200, check=False)
    assert ended.returncode == 0, f"{command}: {ended.stderr}"


class LiveTest(unittest.TestCase):
    """A program that shows itself while the class's tests run."""

    speed = "5"

    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.out = os.path.join(cls.holder.name, "out")
        cls.live = subprocess.Popen(
            [SETSQUARE, "live", "--replay", cls.log, "--speed", cls.speed, "--map-period", "0.3", "--view", "0",
             *cls.made_options()], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        cls.port = int(re.search(r"^shown at http://127.0.0.1:(\d+)$", cls.live.stdout.readline())[1])
        cls.host = f"127.0.0.1:{cls.port}"

    @classmethod
    def made_options(cls):
        return ["-o", cls.out]

    @classmethod
    def tearDownClass(cls):
        cls.live.send_signal(signal.SIGTERM)
        told, errors = cls.live.communicate(timeout=120)
        cls.holder.cleanup()
        assert cls.live.returncode == 0, errors + told

    # --- Without a browser ---

    def ask(self, request, patience_s=5):
        """What comes back for bytes, until the other side ends, or for so long."""
        deadline = time.monotonic() + patience_s
        with socket.create_connection(("127.0.0.1", self.port), timeout=patience_s) as peer:
            answer = b""
            try:
                peer.sendall(request)
                while time.monotonic() < deadline and (piece := peer.recv(65536)):
                    answer += piece
            except (TimeoutError, ConnectionError):
                pass
        return answer

    def status_of(self, method="GET", target="/", host=None, fields=()):
        lines = [f"{method} {target} HTTP/1.1", f"Host: {self.host if host is None else host}", *fields, "", ""]
        answer = self.ask("\r\n".join(lines).encode())
        return int(answer.split(b" ", 2)[1]) if answer.startswith(b"HTTP/1.1 ") else None

    def upgrade(self, origin, host=None):
        key = base64.b64encode(bytes(16)).decode()
        fields = ["Connection: Upgrade", "Upgrade: websocket", "Sec-WebSocket-Version: 13",
                  f"Sec-WebSocket-Key: {key}"]
        if origin is not None:
            fields.append("Origin: " + origin)
        return "\r\n".join(["GET /live HTTP/1.1", f"Host: {host or self.host}", *fields, "", ""]).encode()


class WhatNoBrowserSends(LiveTest):
    speed = "1"

    def test_the_page_is_there_and_nothing_else(self):
        self.assertEqual(self.status_of(), 200)
        self.assertEqual(self.status_of(target="/etc/passwd"), 404)
        self.assertEqual(self.status_of(target="/../../etc/passwd"), 404)
        self.assertEqual(self.status_of(method="POST", fields=["Content-Length: 0"]), 405)
        self.assertEqual(self.status_of(method="DELETE", target="/live"), 405)
        self.assertEqual(self.status_of(target="/live"), 426)

    def test_no_other_site_commands_it(self):
        for host in ["evil.example", f"evil.example:{self.port}", ""]:
            self.assertEqual(self.status_of(host=host), 403, host)
        for origin in [None, "http://evil.example", "null", "http://127.0.0.1:1", f"https://{self.host}"]:
            self.assertTrue(self.ask(self.upgrade(origin)).startswith(b"HTTP/1.1 403"), origin)
        # A name that somebody else's name server leads here.
        rebound = self.upgrade("http://evil.example", "evil.example")
        self.assertTrue(self.ask(rebound).startswith(b"HTTP/1.1 403"))
        own = self.ask(self.upgrade(f"http://{self.host}"), patience_s=1)
        self.assertTrue(own.startswith(b"HTTP/1.1 101"), own[:200])

    def test_damaged_requests_are_survived(self):
        print("seed", SEED)
        chance = random.Random(SEED)
        whole = self.upgrade(f"http://{self.host}")
        for _ in range(200):
            damaged = bytearray(whole)
            for _ in range(chance.randrange(1, 20)):
                damaged[chance.randrange(len(damaged))] = chance.randrange(256)
            with socket.create_connection(("127.0.0.1", self.port), timeout=5) as peer:
                peer.sendall(bytes(damaged[:chance.randrange(1, len(damaged) + 1)]))
        with socket.create_connection(("127.0.0.1", self.port), timeout=5) as peer:
            try:
                peer.sendall(b"GET / HTTP/1.1\r\nX: " + b"x" * 1_000_000)  # a head without an end
            except ConnectionError:
                pass
        self.assertEqual(self.status_of(), 200)

    def test_commands_that_are_none_are_refused(self):
        texts = [b"", b"{", b"[" * 5000, b"1", b'{"do": 1}', b'{"do": "pause"}', b'{"do": "set_pose", "x": 1e99}',
                 b'{"do": "set_pose", "x": 1, "y": 2, "heading": "3"}', b'{"do": "reset all"}']
        for text in texts:
            with socket.create_connection(("127.0.0.1", self.port), timeout=5) as peer:
                peer.sendall(self.upgrade(f"http://{self.host}"))
                self.assertIn(b" 101 ", peer.recv(65536))
                peer.sendall(client_frame(text))
                answer, deadline = b"", time.monotonic() + 20
                while b"not understood" not in answer and time.monotonic() < deadline:
                    answer += peer.recv(65536)
            self.assertIn(b"not understood", answer, text)
        self.assertEqual(self.status_of(), 200)
        self.assertIsNone(self.live.poll())

    def test_one_who_does_not_read_holds_up_nobody_and_memory_stays(self):
        lazy = []
        for _ in range(5):
            peer = socket.create_connection(("127.0.0.1", self.port), timeout=5)
            peer.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            peer.sendall(self.upgrade(f"http://{self.host}"))
            lazy.append(peer)
        time.sleep(1)
        before = resident_kb(self.live.pid)
        time.sleep(3)
        self.assertLess(resident_kb(self.live.pid) - before, 40_000)  # The map grows, too.
        self.assertEqual(self.status_of(), 200)
        for peer in lazy:
            peer.close()


class WhileNoScanComes(LiveTest):
    """A robot whose scanner has stopped, before anybody looked."""

    speed = "1"

    @classmethod
    def setUpClass(cls):
        cls.log = LiveTest.log_that_stops
        super().setUpClass()

    def test_whoever_comes_late_sees_the_last_scan(self):
        time.sleep(2.0)  # The scans take one, and then nothing comes for long.
        heard = self.ask(self.upgrade(f"http://{self.host}"), patience_s=1.5)
        pose = re.search(rb'\{[^{}]*"scan":\[([^]]*)\][^{}]*"type":"pose"[^{}]*\}', heard)
        self.assertTrue(pose, heard[-300:])
        self.assertGreater(len(pose[1].split(b",")), 100)


def client_frame(text):
    """A WebSocket's text frame, masked by zeros."""
    size = len(text)
    head = bytes([0x81, 0x80 | size]) if size < 126 else bytes([0x81, 0x80 | 126]) + size.to_bytes(2, "big")
    return head + bytes(4) + text


def resident_kb(pid):
    with open(f"/proc/{pid}/status", encoding="ascii") as file:
        return int(re.search(r"VmRSS:\s+(\d+)", file.read())[1])


@unittest.skipUnless(chromium.find(), "no Chromium here (tools/install_packages browser)")
class BrowserTest(LiveTest):
    browser = None

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser = chromium.Chromium(chromium.find(), width=1280, height=860).__enter__()
        cls.browser.visit(f"http://{cls.host}/", "setsquare.drawing.map.number > 0 && setsquare.pose?.placed === true")

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        super().tearDownClass()

    def tearDown(self):
        for event in self.browser.events:
            method, params = event["method"], event["params"]
            self.assertNotIn(method, ("Runtime.exceptionThrown", "Runtime.consoleAPICalled"), params)
            self.assertNotEqual(method, "Log.entryAdded", params)
            if method == "Network.requestWillBeSent":
                self.assertRegex(params["request"]["url"], rf"^(http://{self.host}/$|data:)")

    def value(self, script):
        return self.browser.evaluate(script)

    def color(self, name):
        text = self.value(f"getComputedStyle(document.documentElement)"
                          f".getPropertyValue('--{name}').trim()")
        return tuple(int(text[k:k + 2], 16) for k in (1, 3, 5))

    def picture(self):
        self.browser.settle()
        left, top, width, height = self.value(
            "(() => { const r = document.querySelector('#map').getBoundingClientRect();"
            " return [r.left + scrollX, r.top + scrollY, r.width, r.height]; })()")
        return Picture(self.browser.screenshot((left, top, width, height)))

    def num_of(self, picture, name):
        return sum(1 for _ in picture.places(self.color(name), 30))

    def press(self, identifier):
        self.value(f"document.getElementById('answer').textContent = '';"
                   f"document.getElementById('{identifier}').click()")
        if identifier != "set-pose":
            self.browser.wait_for("!['', 'asked'].includes(document.getElementById('answer').textContent)")
        return self.value("document.getElementById('answer').textContent")


class WhileAMapIsMade(BrowserTest):
    def test_the_map_the_scan_the_way_and_the_robot_are_drawn(self):
        self.browser.wait_for("setsquare.drawing.way.length > 20 && setsquare.pose.scan.length > 50")
        picture = self.picture()
        for name, least in [("wall", 100), ("free", 1000), ("current", 50), ("recovered", 60), ("time-1", 20)]:
            self.assertGreater(self.num_of(picture, name), least, name)

    def test_the_map_grows_and_the_robot_moves(self):
        number, x, y = self.value("[setsquare.drawing.map.number, setsquare.pose.x, setsquare.pose.y]")
        self.browser.wait_for(f"setsquare.drawing.map.number > {number + 1} && "
                              f"Math.hypot(setsquare.pose.x - {x}, setsquare.pose.y - {y}) > 0.5")
        self.assertIn("mapping", self.value("document.getElementById('state').textContent"))
        self.assertIn("x ", self.value("document.getElementById('facts').textContent"))

    def test_the_map_is_saved(self):
        self.assertIn("written", self.press("save"))
        self.assertTrue(os.path.exists(os.path.join(self.out, "map.yaml")))

    def test_it_pauses_and_goes_on(self):
        self.assertEqual(self.press("pause"), "paused")
        self.browser.wait_for("setsquare.report.paused")
        self.assertEqual(self.press("pause"), "going on")
        self.browser.wait_for("!setsquare.report.paused")

    def test_a_pose_cannot_be_set(self):
        self.assertTrue(self.value("document.getElementById('set-pose').disabled"))


class WhileARobotIsLocalised(BrowserTest):
    @classmethod
    def made_options(cls):
        return ["--localize", LiveTest.known_map]

    def test_it_is_found_in_the_map(self):
        self.browser.wait_for("document.getElementById('state').textContent === 'localised'")
        self.assertTrue(self.value("document.getElementById('save').disabled"))
        picture = self.picture()
        self.assertGreater(self.num_of(picture, "wall"), 100)
        self.assertGreater(self.num_of(picture, "recovered"), 60)

    def test_other_places_are_drawn_with_their_probabilities(self):
        self.assertEqual(self.num_of(self.picture(), "lost"), 0)
        x, y = self.value("[setsquare.pose.x, setsquare.pose.y]")
        self.value("setsquare.drawing.showReal = setsquare.drawing.showPlaces;"
                   "setsquare.drawing.showPlaces = () => {};"  # Reports go on.
                   f"setsquare.drawing.showReal([[{x} + 2, {y}, 0, 1], [{x}, {y} + 2, 1, 0.25]])")
        # The view moves along with the robot: a picture counts where it stood still meanwhile.
        for _ in range(20):
            column, row = self.value(f"setsquare.drawing.pixel({x} + 2, {y})")
            picture = self.picture()
            if self.value(f"setsquare.drawing.pixel({x} + 2, {y})") == [column, row]:
                break
        near = [place for place in picture.places(self.color("lost"), 30)
                if abs(place[0] - column) < 25 and abs(place[1] - row) < 25]
        self.assertGreater(len(near), 60)
        self.value("delete setsquare.drawing.showPlaces; setsquare.drawing.showPlaces([])")
        self.assertEqual(self.num_of(self.picture(), "lost"), 0)

    def test_a_pose_is_set_by_hand_and_dropped_where_the_scans_contradict(self):
        self.assertIn("Press where", self.press("set-pose"))
        left, top = self.value("(() => { const r = document.querySelector('#map').getBoundingClientRect();"
                               " return [r.left, r.top]; })()")
        column, row = self.value("setsquare.drawing.pixel(setsquare.pose.x + 3, setsquare.pose.y + 2)")
        self.browser.drag((left + column, top + row), (left + column + 60, top + row))
        self.browser.wait_for("document.getElementById('answer').textContent === 'the pose is tried'")
        self.assertEqual(self.value("document.getElementById('set-pose').getAttribute('aria-pressed')"), "false")
        self.browser.wait_for("setsquare.report.doing === 'localised' && setsquare.pose.placed")


def write_log_that_stops():
    """Some scans, and then one a month."""
    with open(LiveTest.log, encoding="ascii") as log:
        scans = [line.split() for line in log if line.startswith("ROBOTLASER1")][:10]
    for months, scan in enumerate(scans[6:], 1):
        for field in (-3, -1):
            scan[field] = str(float(scan[field]) + 2.6e6 * months)
    with open(LiveTest.log_that_stops, "w", encoding="ascii") as log:
        log.writelines(" ".join(scan) + "\n" for scan in scans)


def main():
    with tempfile.TemporaryDirectory() as folder:
        LiveTest.log = os.path.join(folder, "sim", "scans.clf")
        LiveTest.log_that_stops = os.path.join(folder, "stops.clf")
        LiveTest.known_map = os.path.join(folder, "map")
        run("simulate", "--building", "office", "--no-people", "--beams", "180", "--rate", "5", "-o",
            os.path.dirname(LiveTest.log))
        run("map", LiveTest.log, "-o", LiveTest.known_map)
        write_log_that_stops()
        del sys.argv[1]
        return 0 if unittest.main(exit=False, verbosity=2).result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
