# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Compares the JSON lines that `setsquare convert` writes with what an independent reader found."""
import bisect
import decimal
import json
import math
import struct

ANGLE_TOLERANCE_RAD = 1e-6  # a message holds angles as float32
POSE_TOLERANCE = 1e-9       # m and rad


class Difference(AssertionError):
    """What setsquare wrote differs from what an independent reader found."""


def require(is_right, what):
    if not is_right:
        raise Difference(what)


def records_in(path):
    """The records of a file of JSON lines. Numbers keep their digits, for stamps."""
    with open(path, encoding="utf-8") as file:
        return [json.loads(line, parse_float=decimal.Decimal) for line in file]


def stamp_ns(record):
    return int(decimal.Decimal(record["stamp"]) * 1_000_000_000)


def number(value):
    """A range as either side writes it."""
    return math.nan if value is None else float(value)


def as_float32(values):
    return struct.unpack(f"{len(values)}f", struct.pack(f"{len(values)}f", *values))


def are_same_numbers(left, right):
    """As float32, which a message holds: setsquare gives the decimal number that was meant."""
    return len(left) == len(right) and all(
        a == b or (math.isnan(a) and math.isnan(b))
        for a, b in zip(as_float32(left), as_float32(right)))


def angle_between(left, right):
    return abs(math.remainder(left - right, 2.0 * math.pi))


def compare_scan(record, line, has_odd_angles):
    where = f"scan at {line['stamp_ns']}"
    require(stamp_ns(record) == int(line["stamp_ns"]), f"{where}: stamp {record['stamp']}")
    ranges = [number(value) for value in line["ranges"]]
    step = line["angle_increment"]
    is_full_turn = abs(abs(step) * (len(ranges) - 1) - 2.0 * math.pi) < abs(step) / 2
    written = [number(value) for value in record["ranges"]]
    if is_full_turn and len(written) == len(ranges) - 1:
        ranges.pop()  # it points where the first does
    require(are_same_numbers(written, ranges), f"{where}: other ranges")
    if has_odd_angles:
        return
    require(angle_between(float(record["angle_min"]), line["angle_min"]) < ANGLE_TOLERANCE_RAD,
            f"{where}: angle_min {record['angle_min']}, not {line['angle_min']}")
    require(abs(float(record["angle_step"]) - step) < ANGLE_TOLERANCE_RAD,
            f"{where}: angle_step {record['angle_step']}, not {step}")


def topic_of_sensor(sensor, scans):
    """The topic that a scanner's name means: itself, a frame's, or the only one."""
    for line in scans:
        if sensor in (line["topic"], line["topic"].lstrip("/"), line["frame"]):
            return line["topic"]
    topics = {line["topic"] for line in scans}
    require(len(topics) == 1, f"no topic for the scanner {sensor} among {sorted(topics)}")
    return topics.pop()


def compare_scans(records, lines, has_odd_angles=False):
    """Every scan of every topic, by stamp: some readers sort by the time of recording."""
    scans = [line for line in lines if line["kind"] == "scan"]
    by_topic = {}
    for record in records:
        if "ranges" in record:
            by_topic.setdefault(topic_of_sensor(record["sensor"], scans), []).append(record)
    topics = {line["topic"] for line in scans}
    require(set(by_topic) == topics, f"scans of {sorted(by_topic)}, not of {sorted(topics)}")
    for topic, written in by_topic.items():
        expected = [line for line in scans if line["topic"] == topic]
        require(len(written) == len(expected), f"{len(written)} scans of {topic}, not {len(expected)}")
        written.sort(key=stamp_ns)
        expected.sort(key=lambda line: int(line["stamp_ns"]))
        for record, line in zip(written, expected):
            compare_scan(record, line, has_odd_angles)


def compare_order(records):
    """The stamps of each topic's records ascend."""
    last = {}
    for record in records:
        stamp = stamp_ns(record)
        require(last.get(record["sensor"], stamp) <= stamp, f"record at {record['stamp']} too late")
        last[record["sensor"]] = stamp


def distance(left, right):
    return math.hypot(left[0] - right[0], left[1] - right[1]) + angle_between(left[2], right[2])


def pose_of(line):
    return (line["x"], line["y"], line["yaw"])


def odometry_lines(records, lines):
    """The messages that state odometry: not those of a topic that states the truth, but the
    transforms between the same frames."""
    truth = {record["sensor"] for record in records if record.get("true_pose") is not None}
    messages = [line for line in lines if line["kind"] == "odometry" and line["topic"] not in truth]
    frames = {(line["frame"], line["child_frame"]) for line in messages}
    return messages + [line for line in lines if line["kind"] == "transform"
                       and (line["frame"], line["child_frame"]) in frames]


def compare_stated_poses(records, lines):
    """Every pose that is no scan's is that of a message of its topic at the same stamp."""
    stated = {}
    for line in lines:
        if line["kind"] != "scan":
            stated.setdefault((line["topic"], int(line["stamp_ns"])), []).append(pose_of(line))
    for record in records:
        pose = record.get("true_pose") or record.get("odometry")
        if "ranges" in record or pose is None:
            continue
        poses = stated.get((record["sensor"], stamp_ns(record)), [])
        pose = [float(value) for value in pose]
        require(any(distance(pose, one) < POSE_TOLERANCE for one in poses),
                f"pose of {record['sensor']} at {record['stamp']}: {pose}, not {poses}")


def compare_odometry(records, lines):
    """Every scan's pose by odometry is that of a message at the same stamp, or lies between its
    neighbours. Returns how many scans have one."""
    messages = sorted((int(line["stamp_ns"]), pose_of(line)) for line in odometry_lines(records, lines))
    stamps = [stamp for stamp, _ in messages]
    num_scans = 0
    for record in records:
        if "ranges" not in record or record.get("odometry") is None:
            continue
        num_scans += 1
        pose = [float(value) for value in record["odometry"]]
        stamp = stamp_ns(record)
        after = min(bisect.bisect_left(stamps, stamp), len(stamps) - 1)
        before = after if stamps[after] == stamp else max(after - 1, 0)
        begin, end = messages[before][1], messages[after][1]
        detour = distance(begin, pose) + distance(pose, end) - distance(begin, end)
        # Around a curve the way is a little longer than from end to end.
        allowed = POSE_TOLERANCE if before == after else 0.05 * distance(begin, end) + POSE_TOLERANCE
        require(detour <= 2.0 * allowed, f"odometry at {record['stamp']}: {pose}, {detour} off")
    return num_scans


def compare_mounting(records, mounting):
    for record in records:
        if "ranges" in record:
            written = [float(value) for value in record["mounting"]]
            require(distance(written, mounting) < 1e-6, f"mounting {written}, not {mounting}")
