# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""What `setsquare map` wrote about each scan."""
import base64
import json
import math
import re

from trial.judge import DOUBTS, MappedPose

REPORT = re.compile(r'<script type="application/json" id="report">(.*?)</script>', re.DOTALL)


def poses_of(path):
    """A trajectory in TUM: [(stamp as text, (x, y, heading))]."""
    rows = [line.split() for line in path.read_text().splitlines() if not line.startswith("#")]
    return [(row[0], (float(row[1]), float(row[2]), 2 * math.atan2(float(row[6]), float(row[7]))))
            for row in rows]


def _unpacked(text):
    """A column of report.html: differences, signs in the lowest bit, seven bits a byte."""
    values, value, folded, shift = [], 0, 0, 0
    for byte in base64.b64decode(text):
        folded |= (byte & 127) << shift
        shift += 7
        if byte & 128:
            continue
        value += -(folded + 1) // 2 if folded % 2 else folded // 2
        values.append(value)
        folded = shift = 0
    return values


def _sigmas_m(folder):
    report = json.loads(REPORT.search((folder / "report.html").read_text()).group(1))
    return [1e-3 * max(0, value) for value in _unpacked(report["poses"]["sigma"])]


def _scans(part):
    return range(part["first_scan"], part["first_scan"] + part["num_scans"])


def mapped_poses(folder):
    """{stamp as text: MappedPose} of a folder that `setsquare map` filled, and its run.json. An
    open stretch doubts no pose in it, but none there is surer than the stretch's length is."""
    run = json.loads((folder / "run.json").read_text())
    whole = tuple(f["kind"] for f in run["findings"] if f["kind"] in DOUBTS)
    poses = poses_of(folder / "trajectory.tum")
    mapped = [MappedPose(pose, sigma_m, True, whole)
              for (_, pose), sigma_m in zip(poses, _sigmas_m(folder), strict=True)]
    for piece in run["pieces"]:
        for scan in _scans(piece):
            mapped[scan].is_placed = piece["joined"]
    for stretch in run["stretches"]:
        for scan in _scans(stretch) if stretch["status"] == "lost" else ():
            mapped[scan].is_placed = False
            mapped[scan].doubts += ("lost",)
    for stretch in run["open_stretches"]:
        for scan in _scans(stretch):
            mapped[scan].sigma_m = max(mapped[scan].sigma_m, stretch["length_sigma_m"])
    return {stamp: pose for (stamp, _), pose in zip(poses, mapped)}, run
