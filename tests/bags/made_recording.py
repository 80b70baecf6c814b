# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""The content of the recordings that the tests make, and how lines describe any recording.

A line is a dictionary, in files one JSON object per line, in the order of recording:

  {"kind": "scan", "topic": "/scan", "log_time_ns": "17...", "stamp_ns": "17...", "frame": "laser",
   "angle_min": rad, "angle_max": rad, "angle_increment": rad, "time_increment": s, "scan_time": s,
   "range_min": m, "range_max": m, "ranges": [m, "inf", "-inf", "nan" ...]}
  {"kind": "odometry", "topic", "log_time_ns", "stamp_ns", "frame", "child_frame", "x", "y", "yaw"}
  {"kind": "transform", "topic": "/tf" or "/tf_static", and else as odometry}

Nanoseconds are texts, since a number in JSON need not keep their digits.
"""
import math
import struct

START_NS = 1_700_000_000_123_456_789
NUM_SCANS = 60
NUM_BEAMS = 181
MOUNTING = (0.2, -0.05, 0.3)


def float32(value):
    """The nearest number that a message's float32 holds."""
    return struct.unpack("<f", struct.pack("<f", value))[0]


def pose_line(kind, topic, stamp_ns, frames, pose):
    delay_ns = 1_000_000 if kind == "odometry" else 1_200_000
    return {"kind": kind, "topic": topic, "log_time_ns": str(stamp_ns + delay_ns),
            "stamp_ns": str(stamp_ns), "frame": frames[0], "child_frame": frames[1],
            "x": pose[0], "y": pose[1], "yaw": pose[2]}


def ranges_of(scan):
    ranges = [float32(2.0 + ((7 * beam + 3 * scan) % 100) / 50.0) for beam in range(NUM_BEAMS)]
    ranges[scan % NUM_BEAMS] = "inf"
    ranges[(scan + 5) % NUM_BEAMS] = "nan"
    ranges[(scan + 9) % NUM_BEAMS] = "-inf"
    ranges[(scan + 20) % NUM_BEAMS] = 0.0
    return ranges


def scan_line(scan, stamp_ns):
    return {"kind": "scan", "topic": "/scan", "log_time_ns": str(stamp_ns + 1_500_000),
            "stamp_ns": str(stamp_ns), "frame": "laser",
            "angle_min": float32(-math.pi / 2), "angle_max": float32(math.pi / 2),
            "angle_increment": float32(math.pi / (NUM_BEAMS - 1)), "time_increment": 0.0,
            "scan_time": float32(0.1), "range_min": float32(0.05), "range_max": 30.0,
            "ranges": ranges_of(scan)}


def lines():
    """A drive with scans at 10 Hz, odometry at 50 Hz (one with each scan), and transforms."""
    made = [pose_line("transform", "/tf_static", START_NS, ("base_link", "laser"), MOUNTING)]
    for step in range(5 * NUM_SCANS):
        stamp_ns = START_NS + 20_000_000 * step
        pose = (0.01 * step, 0.002 * step, math.remainder(0.005 * step, 2.0 * math.pi))
        made.append(pose_line("odometry", "/odom", stamp_ns, ("odom", "base_link"), pose))
        made.append(pose_line("transform", "/tf", stamp_ns, ("odom", "base_link"), pose))
        if step % 5 == 0:
            made.append(scan_line(step // 5, stamp_ns))
    return made
