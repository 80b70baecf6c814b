# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""What goes wrong with a log. A log is a list of scans, dictionaries as `setsquare simulate --format
jsonl` writes them, each with its "truth": (x, y, theta) of the robot. A fault takes such a list and
a random.Random, and returns the list of the spoilt log; what it does not change is shared."""
import math

SEES_NOTHING = "inf"


def _bearings(scan):
    return [scan["angle_min"] + k * scan["angle_step"] for k in range(len(scan["ranges"]))]


def _is_return(value):
    return isinstance(value, (int, float)) and math.isfinite(value)


def _returns_edited(scans, edit):
    """Every return of every scan replaced by edit(range)."""
    return [{**scan, "ranges": [edit(r) if _is_return(r) and r < scan["range_max"] else r
                                for r in scan["ranges"]]} for scan in scans]


def short_sight(limit_m, noise_m=0.0):
    """A poor lidar: nothing beyond `limit_m`, and more noise."""
    def fault(scans, draw):
        near = _returns_edited(
            scans, lambda r: r + draw.gauss(0, noise_m) if r < limit_m else SEES_NOTHING)
        return [{**scan, "range_max": limit_m} for scan in near]
    return fault


def stops(num, duration_s):
    """The robot stands so long at `num` places, evenly over the log, the scans with fresh noise."""
    def fault(scans, draw):
        period_s = scans[1]["stamp"] - scans[0]["stamp"]
        at = {(k + 1) * len(scans) // (num + 1) for k in range(num)}
        stopped, late_s = [], 0.0
        for i, scan in enumerate(scans):
            stopped.append({**scan, "stamp": scan["stamp"] + late_s})
            if i in at:
                for _ in range(round(duration_s / period_s)):
                    late_s += period_s
                    still = _returns_edited([scan], lambda r: max(0.05, r + draw.gauss(0, 0.01)))[0]
                    stopped.append({**still, "stamp": scan["stamp"] + late_s})
        return stopped
    return fault


def uneven_speed(most, least_s=2.0, longest_s=6.0):
    """Where it does not turn the robot drives at one to `most` times its speed, another multiple
    every few seconds."""
    def fault(scans, draw):
        period_s = scans[1]["stamp"] - scans[0]["stamp"]
        driven, i, change = [], 0, 0
        while i < len(scans):
            if len(driven) >= change:
                multiple = draw.randint(1, most)
                change = len(driven) + round(draw.uniform(least_s, longest_s) / period_s)
            driven.append({**scans[i], "stamp": scans[0]["stamp"] + len(driven) * period_s})
            is_turning = abs(scans[i]["truth"][2] - scans[max(i - 1, 0)]["truth"][2]) > 0.005
            i += 1 if is_turning else multiple
        return driven
    return fault


# Odometry.

def _with_odometry(scans, poses):
    return [{**scan, "odometry": list(pose)} for scan, pose in zip(scans, poses)]


def _steps(scans):
    """Motion from scan to scan by odometry, in the robot's frame."""
    steps = []
    for before, after in zip(scans, scans[1:]):
        (x, y, h), (u, v, g) = before["odometry"], after["odometry"]
        c, s = math.cos(h), math.sin(h)
        steps.append((c * (u - x) + s * (v - y), c * (v - y) - s * (u - x),
                      math.remainder(g - h, 2 * math.pi)))
    return steps


def _chained(start, steps):
    poses = [tuple(start)]
    for forward, left, turn in steps:
        x, y, h = poses[-1]
        c, s = math.cos(h), math.sin(h)
        poses.append((x + c * forward - s * left, y + s * forward + c * left,
                      math.remainder(h + turn, 2 * math.pi)))
    return poses


def odometry_zero(scans, _draw):
    return _with_odometry(scans, [(0.0, 0.0, 0.0)] * len(scans))


def odometry_frozen(share):
    """From this share of the log on."""
    def fault(scans, _draw):
        last = int(share * len(scans))
        return _with_odometry(scans, [scans[min(i, last)]["odometry"] for i in range(len(scans))])
    return fault


def odometry_mirrored(scans, _draw):
    return _with_odometry(scans, [(x, -y, -h) for x, y, h in (s["odometry"] for s in scans)])


def odometry_scaled(way=1.0, turn=1.0):
    def fault(scans, _draw):
        steps = [(way * x, way * y, turn * h) for x, y, h in _steps(scans)]
        return _with_odometry(scans, _chained(scans[0]["odometry"], steps))
    return fault


def odometry_jump(far_m):
    """One pose in the middle of the log."""
    def fault(scans, _draw):
        poses = [scan["odometry"] for scan in scans]
        poses[len(poses) // 2] = [far_m, 0.0, 0.0]
        return _with_odometry(scans, poses)
    return fault


def odometry_delayed(delay_s):
    def fault(scans, _draw):
        late = round(delay_s / (scans[1]["stamp"] - scans[0]["stamp"]))
        return _with_odometry(scans, [scans[max(0, i - late)]["odometry"] for i in range(len(scans))])
    return fault


def _window(scans, way_m):
    """The scans from the middle of the log on in which the robot moves so far."""
    first = last = len(scans) // 2
    while last + 1 < len(scans) and math.dist(scans[first]["truth"][:2],
                                              scans[last]["truth"][:2]) < way_m:
        last += 1
    return first, last


def carried(way_m, is_seen):
    """The wheels rest while somebody carries the robot so far; the scanner sees it or is covered."""
    def fault(scans, _draw):
        first, last = _window(scans, way_m)
        steps = [(0.0, 0.0, 0.0) if first <= i < last else step
                 for i, step in enumerate(_steps(scans))]
        moved = _with_odometry(scans, _chained(scans[0]["odometry"], steps))
        return moved if is_seen else moved[:first + 1] + moved[last:]
    return fault


# Scans.

def paused(duration_s):
    """The log has no scans for so long; the robot drives on."""
    def fault(scans, _draw):
        begin_s = scans[len(scans) // 2]["stamp"]
        return [s for s in scans if not begin_s < s["stamp"] < begin_s + duration_s]
    return fault


def stuck(duration_s):
    """The driver sends the same scan for so long while the robot drives on, and the odometry with
    it: true is where the robot is."""
    def fault(scans, _draw):
        first = len(scans) // 2
        end_s = scans[first]["stamp"] + duration_s
        return [{**s, "ranges": scans[first]["ranges"]} if i > first and s["stamp"] < end_s else s
                for i, s in enumerate(scans)]
    return fault


def sent_again(num):
    """Every scan is sent `num` times instead of the next ones; true is where it was taken."""
    def fault(scans, _draw):
        taken = [scans[i - i % num] for i in range(len(scans))]
        return [{**then, "stamp": now["stamp"], "odometry": now["odometry"]}
                for now, then in zip(scans, taken)]
    return fault


def posts(num, width_deg):
    """Posts of the robot itself, 0.2 to 0.4 m off the scanner, in every scan."""
    def fault(scans, draw):
        placed = [(draw.uniform(-2.0, 2.0), draw.uniform(0.2, 0.4)) for _ in range(num)]
        half = math.radians(0.5 * width_deg)

        def seen(scan):
            ranges = list(scan["ranges"])
            for k, bearing in enumerate(_bearings(scan)):
                for at, range_m in placed:
                    if abs(math.remainder(bearing - at, 2 * math.pi)) <= half:
                        ranges[k] = range_m + draw.gauss(0, 0.003)
            return {**scan, "ranges": ranges}
        return [seen(scan) for scan in scans]
    return fault


def noisy(sigma_m):
    """Every range is off by as much."""
    def fault(scans, draw):
        return _returns_edited(scans, lambda r: max(0.05, r + draw.gauss(0, sigma_m)))
    return fault


def missing(share):
    """This share of the returns does not come back."""
    def fault(scans, draw):
        return _returns_edited(scans, lambda r: SEES_NOTHING if draw.random() < share else r)
    return fault


def every_beam(step):
    """A scanner of fewer beams: each `step`-th of these."""
    def fault(scans, _draw):
        return [{**scan, "ranges": scan["ranges"][::step], "angle_step": step * scan["angle_step"]}
                for scan in scans]
    return fault


def field_of_view(width_deg):
    """Only the beams within half of the width of the middle one."""
    def fault(scans, _draw):
        def narrow(scan):
            num = len(scan["ranges"])
            kept = min(num, 1 + round(math.radians(width_deg) / abs(scan["angle_step"])))
            first = (num - kept) // 2
            return {**scan, "ranges": scan["ranges"][first:first + kept],
                    "angle_min": scan["angle_min"] + first * scan["angle_step"]}
        return [narrow(scan) for scan in scans]
    return fault


def every_scan(step):
    """A scanner, or a recorder, that takes each `step`-th of these scans."""
    def fault(scans, _draw):
        return scans[::step]
    return fault


def _moved(before, after):
    """Way in m and turn in deg from one scan to another."""
    (x, y, h), (u, v, g) = before["truth"], after["truth"]
    return math.hypot(u - x, v - y), abs(math.degrees(math.remainder(g - h, 2 * math.pi)))


def key_frames(way_m, turn_deg):
    """A log that has a scan only where the robot has moved so far since the last."""
    def fault(scans, _draw):
        kept = scans[:1]
        for scan in scans[1:]:
            moved_m, turned_deg = _moved(kept[-1], scan)
            if moved_m >= way_m or turned_deg >= turn_deg:
                kept.append(scan)
        return kept
    return fault


def uneven_key_frames(way_m, turn_deg):
    """The same from some scan among the first, at ways and turns that differ: by up to 30 % less and 15 % more."""
    def fault(scans, draw):
        first = draw.randrange(min(50, len(scans)))
        kept, longest_m, longest_deg = [scans[first]], way_m, turn_deg
        for scan in scans[first + 1:]:
            moved_m, turned_deg = _moved(kept[-1], scan)
            if moved_m > longest_m or turned_deg > longest_deg:
                kept.append(scan)
                longest_m = way_m * draw.uniform(0.7, 1.15)
                longest_deg = turn_deg * draw.uniform(0.7, 1.15)
        return kept
    return fault


def glass(share, cell_m=2.0):
    """In this share of the squares of the building the walls are of glass: nothing comes back."""
    def fault(scans, draw):
        is_glass = {}

        def seen(scan):
            x, y, heading = scan["truth"]
            ranges = list(scan["ranges"])
            for k, bearing in enumerate(_bearings(scan)):
                if not _is_return(ranges[k]):
                    continue
                cell = (math.floor((x + ranges[k] * math.cos(heading + bearing)) / cell_m),
                        math.floor((y + ranges[k] * math.sin(heading + bearing)) / cell_m))
                if is_glass.setdefault(cell, draw.random() < share):
                    ranges[k] = SEES_NOTHING
            return {**scan, "ranges": ranges}
        return [seen(scan) for scan in scans]
    return fault


def people(num, radius_m=0.2, speed_m_s=1.2):
    """So many people walk about the robot, 0.7 to 4 m off, and hide what is behind them."""
    def fault(scans, draw):
        about = [(draw.uniform(0.7, 4.0), draw.uniform(-math.pi, math.pi)) for _ in range(num)]
        walkers = [(scans[0]["truth"][0] + far * math.cos(at), scans[0]["truth"][1] + far * math.sin(at))
                   for far, at in about]
        aims = list(walkers)
        spoilt, last_s = [], scans[0]["stamp"]
        for scan in scans:
            x, y, heading = scan["truth"]
            way, last_s = speed_m_s * min(1.0, max(0.0, scan["stamp"] - last_s)), scan["stamp"]
            ranges = list(scan["ranges"])
            for i, (u, v) in enumerate(walkers):
                if math.dist(walkers[i], aims[i]) < 0.3 or math.dist(aims[i], (x, y)) > 4.0:
                    far, at = draw.uniform(0.7, 4.0), draw.uniform(-math.pi, math.pi)
                    aims[i] = (x + far * math.cos(at), y + far * math.sin(at))
                rest = math.dist(walkers[i], aims[i])
                if math.dist(walkers[i], (x, y)) > 5.0:
                    u, v = aims[i]  # Somebody else.
                elif rest > 1e-9:
                    u += min(way, rest) * (aims[i][0] - u) / rest
                    v += min(way, rest) * (aims[i][1] - v) / rest
                walkers[i] = (u, v)
                distance, bearing_of = math.dist((u, v), (x, y)), math.atan2(v - y, u - x) - heading
                if distance <= radius_m + 0.1:
                    continue
                for k, bearing in enumerate(_bearings(scan)):
                    across = distance * math.sin(bearing - bearing_of)
                    along = distance * math.cos(bearing - bearing_of)
                    if along > 0 and abs(across) < radius_m:
                        r = along - math.sqrt(radius_m ** 2 - across ** 2)
                        if not _is_return(ranges[k]) or ranges[k] > r:
                            ranges[k] = max(0.05, r + draw.gauss(0, 0.01))
            spoilt.append({**scan, "ranges": ranges})
        return spoilt
    return fault


def dust(share):
    """This share of the returns comes from something nearer that nothing stands beside."""
    def fault(scans, draw):
        return _returns_edited(
            scans, lambda r: draw.uniform(0.3, r) if r > 0.3 and draw.random() < share else r)
    return fault


def scans_mirrored(scans, _draw):
    """A scanner upside down, or one that counts its beams clockwise; the odometry is right."""
    return [{**scan, "ranges": scan["ranges"][::-1]} for scan in scans]
