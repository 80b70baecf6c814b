# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Scans, matches, maps and errors drawn with Matplotlib.

Each function draws upon `axes`, or upon new ones where none are given, and returns them. Lengths
are in m.
"""

import numpy as np

from setsquare import _core


def _axes_or_new(axes):
    if axes is not None:
        return axes
    import matplotlib.pyplot as plt

    return plt.subplots()[1]


def _finish(axes):
    axes.set_aspect("equal")
    axes.set_xlabel("x in m")
    axes.set_ylabel("y in m")
    return axes


def scan(scan, axes=None, T_frame_sensor=(0.0, 0.0, 0.0), **style):
    """The returns of a scan as points, seen from a frame in which the sensor stands at a pose.

    style: keywords of Axes.plot.
    """
    axes = _axes_or_new(axes)
    points = _core.Pose2(*T_frame_sensor).transform(scan.points())
    axes.plot(points[:, 0], points[:, 1], **{"linestyle": "", "marker": ".", "ms": 3, **style})
    return _finish(axes)


def match(match, axes=None):
    """Both scans of a match in the reference's frame, and the verdict as the title."""
    axes = _axes_or_new(axes)
    scan(match.reference, axes, label="reference")
    if match.T_reference_current is not None:
        scan(match.current, axes, match.T_reference_current, label="current")
    axes.set_title(f"{match.status}, score {match.score:.2f}")
    axes.legend()
    return axes


def map(map, axes=None, path=True, doubts=True):
    """The occupancy grid of a map, the robot's path and the numbered doubts upon it."""
    axes = _axes_or_new(axes)
    grid = map.grid()
    axes.imshow(
        1.0 - grid.probability, cmap="gray", vmin=0.0, vmax=1.0, origin="lower", extent=grid.extent_m
    )
    if path:
        poses = map.trajectory().poses
        axes.plot(poses[:, 0], poses[:, 1], linewidth=0.8)
    if doubts:
        for number, doubt in enumerate(map.doubts, start=1):
            axes.annotate(str(number), doubt.place_m, color="tab:red", weight="bold")
    axes.set_title(map.verdict, wrap=True)
    return _finish(axes)


def _nearest(values, wanted):
    """For each wanted value the index of the nearest of the ascending values."""
    after = np.searchsorted(values, wanted).clip(max=len(values) - 1)
    before = (after - 1).clip(min=0)
    return np.where(np.abs(values[before] - wanted) < np.abs(values[after] - wanted), before, after)


def errors(trajectory, truth, axes=None):
    """The distance of each pose from the true one over time, after the best rigid alignment."""
    axes = _axes_or_new(axes)
    alignment = _core.evaluate_trajectory(trajectory, truth).T_truth_map
    nearest = _nearest(truth.stamps_ns, trajectory.stamps_ns)
    paired = np.abs(truth.stamps_ns[nearest] - trajectory.stamps_ns) <= 12_000
    moved = alignment.transform(trajectory.poses[:, :2])
    distances = np.linalg.norm(moved - truth.poses[nearest, :2], axis=1)
    times = (trajectory.stamps_ns - trajectory.stamps_ns[0]) * 1e-9
    axes.plot(times[paired], distances[paired])
    axes.set_xlabel("time in s")
    axes.set_ylabel("error in m")
    return axes
