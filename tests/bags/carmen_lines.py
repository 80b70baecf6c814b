# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""A CARMEN log's scans and odometry as lines of made_recording.py."""
import math

import made_recording

NO_RETURN_M = 50.0  # the maximum range that `setsquare` assumes of a CARMEN log


def beginning_of(path, num_scans):
    """The lines of the log up to its scan number `num_scans`."""
    with open(path, encoding="ascii") as file:
        for line in file:
            yield line
            num_scans -= line.startswith("FLASER ")
            if num_scans == 0:
                return


def nanoseconds_of(text):
    seconds, decimals = text.split(".")
    return int(seconds) * 1_000_000_000 + int(decimals.ljust(9, "0"))


def scan_line(ranges, stamp_ns):
    """180 beams over 180 degrees, a degree apart, as the convention for FLASER has it."""
    return {"kind": "scan", "topic": "/scan", "log_time_ns": "", "stamp_ns": str(stamp_ns),
            "frame": "laser", "angle_min": -math.pi / 2, "angle_max": math.radians(89.0),
            "angle_increment": math.radians(1.0), "time_increment": 0.0, "scan_time": 0.0,
            "range_min": 0.0, "range_max": NO_RETURN_M, "ranges": ranges}


def odometry_line(pose, stamp_ns):
    return made_recording.pose_line("odometry", "/odom", stamp_ns, ("odom", "base_link"), pose)


def lines_of_record(words):
    """A FLASER line is `FLASER n ranges laser-pose robot-pose stamp host stamp`, an ODOM line
    `ODOM robot-pose three speeds stamp host stamp`."""
    if words[0] == "FLASER":
        num_beams = int(words[1])
        assert num_beams == 180, num_beams
        numbers = [float(word) for word in words[2:2 + num_beams + 6]]
        stamp_ns = nanoseconds_of(words[-3])
        yield odometry_line(numbers[-3:], stamp_ns)
        yield scan_line(numbers[:num_beams], stamp_ns)
    elif words[0] == "ODOM":
        yield odometry_line([float(word) for word in words[1:4]], nanoseconds_of(words[-3]))


def lines_in(text_lines):
    """Recorded one a microsecond, since a log's stamps need not ascend."""
    made = []
    for text in text_lines:
        made.extend(lines_of_record(text.split()))
    start_ns = int(made[0]["stamp_ns"])
    at_robot = (0.0, 0.0, 0.0)
    made.insert(0, made_recording.pose_line("transform", "/tf_static", start_ns,
                                            ("base_link", "laser"), at_robot))
    for number, line in enumerate(made):
        line["log_time_ns"] = str(start_ns + 1000 * number)
    return made
