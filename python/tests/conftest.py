# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
import os
import subprocess

import numpy as np
import pytest

import setsquare

# Corners of a room with a niche and a pillar, so that it looks the same from no two places.
ROOM_M = [(-4, -3), (5, -3), (5, 1), (6.5, 1), (6.5, 2.5), (5, 2.5), (5, 4), (-4, 4)]
PILLAR_M = [(1, 1.5), (1.6, 1.5), (1.6, 2.2), (1, 2.2)]


def walls_m():
    """Both ends of each wall: an array of shape (N, 2, 2)."""
    return np.array(
        [[polygon[i], polygon[(i + 1) % len(polygon)]] for polygon in (ROOM_M, PILLAR_M)
         for i in range(len(polygon))], dtype=float)


def ranges_in_room(pose, num_beams=361, fov_deg=360.0, noise_m=0.01, seed=1):
    """Ranges that a scanner at pose (x_m, y_m, theta_rad) measures in the room."""
    step = np.radians(fov_deg) / (num_beams - 1)
    bearings = pose[2] - np.radians(fov_deg) / 2 + step * np.arange(num_beams)
    rays = np.column_stack([np.cos(bearings), np.sin(bearings)])
    ranges = np.full(num_beams, np.inf)
    for start, end in walls_m():
        along, to_start = end - start, start - np.asarray(pose[:2])
        cross = rays[:, 0] * along[1] - rays[:, 1] * along[0]
        with np.errstate(divide="ignore", invalid="ignore"):
            distance = (to_start[0] * along[1] - to_start[1] * along[0]) / cross
            place = (to_start[0] * rays[:, 1] - to_start[1] * rays[:, 0]) / cross
        hit = (distance > 0) & (place >= 0) & (place <= 1)
        ranges[hit] = np.minimum(ranges[hit], distance[hit])
    return ranges + np.random.default_rng(seed).normal(0.0, noise_m, num_beams)


@pytest.fixture
def room_scan():
    return lambda pose, **options: setsquare.Scan(ranges_in_room(pose, **options), fov_deg=360)


@pytest.fixture(scope="session")
def command():
    """The setsquare command that was built beside the package."""
    path = os.environ.get("SETSQUARE_COMMAND", "")
    if not path:
        pytest.skip("SETSQUARE_COMMAND does not name the command")
    return path


@pytest.fixture(scope="session")
def simulated_log(command, tmp_path_factory):
    """A folder with the log of a drive through a simulated building, and its truth."""
    folder = tmp_path_factory.mktemp("simulated")
    subprocess.run(
        [command, "simulate", "--building", "office", "--seed", "11", "--every", "0.3",
         "-o", str(folder)], check=True, capture_output=True)
    return folder
