# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""What `setsquare map` wrote about each scan."""
import csv
import json
import math

from trial.judge import DOUBTS, MappedPose


# Doubts of run.json that say more than a wide spread does.
TOLD = {"contradicting pairs", "outvoted closures", "undecided turn", "may be mirrored",
        "crossed walls", "loops not closed"}


def poses_of(path):
    """A trajectory in TUM: [(stamp as text, (x, y, heading))]."""
    rows = [line.split() for line in path.read_text().splitlines() if not line.startswith("#")]
    return [(row[0], (float(row[1]), float(row[2]), 2 * math.atan2(float(row[6]), float(row[7]))))
            for row in rows]


def _largest_sigma(sigma_x, sigma_y, correlation):
    """Of a position, along its least certain direction."""
    mean, half = 0.5 * (sigma_x ** 2 + sigma_y ** 2), 0.5 * (sigma_x ** 2 - sigma_y ** 2)
    return math.sqrt(mean + math.hypot(half, correlation * sigma_x * sigma_y))


def _mapped_pose(row, whole):
    """Of a row of poses.tsv. Its own doubts but "lost" and "not_joined" name its spreads again: they
    excuse no more than those."""
    pose = (float(row["x_m"]), float(row["y_m"]), math.radians(float(row["heading_deg"])))
    doubts = tuple(row["doubts"].split(",")) if row["doubts"] != "-" else ()
    has_place = row["placed"] == "1" and "lost" not in doubts
    sigma_m = sigma_deg = 0.0
    if has_place:
        sigma_m = _largest_sigma(*(float(row[name]) for name in (
            "sigma_x_m", "sigma_y_m", "correlation_xy")))
        sigma_deg = float(row["sigma_heading_deg"])
    lost = tuple(doubt for doubt in doubts if doubt in ("lost", "not_joined"))
    return MappedPose(pose, sigma_m, sigma_deg, has_place, whole + lost)


def mapped_poses(folder):
    """{stamp as text: MappedPose} of a folder that `setsquare map` filled, and its run.json. An
    open stretch doubts no pose in it, but none there is surer than the stretch's length is; what
    else the map doubts of itself counts for the scans that it names."""
    run = json.loads((folder / "run.json").read_text())
    whole = tuple(f["kind"] for f in run["findings"] if f["kind"] in DOUBTS)
    with open(folder / "poses.tsv", encoding="ascii", newline="") as table:
        rows = list(csv.DictReader(table, delimiter="\t"))
    mapped = [_mapped_pose(row, whole) for row in rows]
    for stretch in run["open_stretches"]:
        for scan in range(stretch["first_scan"], stretch["first_scan"] + stretch["num_scans"]):
            mapped[scan].sigma_m = max(mapped[scan].sigma_m, stretch["length_sigma_m"])
    for doubt in run.get("doubts", []):
        if doubt["kind"] not in TOLD:
            continue
        for scan in range(doubt["first_scan"], doubt["first_scan"] + doubt["num_scans"]):
            mapped[scan].doubts += (doubt["kind"],)
    return {row["stamp"]: pose for row, pose in zip(rows, mapped)}, run
