# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Whether a map is wrong, and whether it says so.

The map is laid onto the truth where its spreads count from: the first pose that is placed lies on
its truth, and the rotation about it is the best for all placed poses that nothing doubts (for all
where each is doubted), positions weighted by the spread reported for each (at least 0.05 m) and
headings likewise (1 deg). So a map that states a wide spread
behind a corridor is turned by what it is sure of, and a bend is an error of what lies behind it.

A placed pose is wrong and silent if
- it is off by more than 0.5 m and by more than three times the standard deviation of its position,
  or by more than 5 deg and by more than three times that of its heading; and
- nothing that is reported doubts it: a finding about the scans of the whole log, or a doubt of
  run.json whose scans it is among, but for those that name a wide spread. A scan that is lost, or in a piece that was not joined, does not count as placed.
What is said of the odometry is no doubt: the map is to be right all the same."""
import dataclasses
import math
import statistics

FAR_M, FAR_DEG, NUM_SIGMAS = 0.5, 5.0, 3.0
LEAST_SIGMA_M, LEAST_SIGMA_DEG = 0.001, 0.01  # What the outputs resolve.
# Findings that say of all scans that a map by them is not to be trusted.
DOUBTS = {"range_unit", "stamp_unit", "no_returns", "few_beams", "field_of_view", "mirrored",
          "scans_stand"}


@dataclasses.dataclass
class MappedPose:
    """A scan as the map has it: pose (m, rad), standard deviations of the position (m) and of the
    heading (deg), whether it has a place, and what is doubted there."""
    pose: tuple
    sigma_m: float = 0.0
    sigma_deg: float = 0.0
    is_placed: bool = True
    doubts: tuple = ()


def _median(values):
    return statistics.median(values) if values else None


@dataclasses.dataclass
class Verdict:
    num_poses: int
    num_placed: int
    errors_m: list       # Of the placed poses.
    errors_deg: list
    num_wrong: int       # Placed poses that are off by more than is allowed and reported.
    num_silent: int      # Of these, without a doubt.
    num_beyond: int      # Placed poses off by more than three standard deviations, however little,
    num_turned: int      # and those of which the heading is.
    first_silent: int    # Scan, -1 where there is none.
    doubts: tuple = ()
    heading_sigmas_deg: tuple = ()  # As reported of the placed poses.

    @property
    def is_wrong_and_silent(self):
        return self.num_silent > 0

    @property
    def squares_of_headings(self):
        """Of each placed pose the square of its heading's error over the spread reported for it."""
        return [(off / max(sigma, LEAST_SIGMA_DEG)) ** 2
                for off, sigma in zip(self.errors_deg, self.heading_sigmas_deg)]

    def as_json(self):
        worst = {"worst_m": max(self.errors_m, default=None),
                 "worst_deg": max(self.errors_deg, default=None)}
        return {"poses": self.num_poses, "placed": self.num_placed,
                "median_m": _median(self.errors_m), **worst,
                "wrong": self.num_wrong, "silent": self.num_silent, "beyond": self.num_beyond,
                "turned": self.num_turned, "heading_squares": sum(self.squares_of_headings),
                "heading_median_deg": _median(self.errors_deg),
                "heading_sigma_deg": _median(self.heading_sigmas_deg), "first_silent": self.first_silent, "doubts": list(self.doubts)}


def _turned_onto(truth, mapped):
    """The rotation, in rad, that lays placed poses that nothing doubts onto their truth about the
    first of all."""
    is_sure = [not placed.doubts for placed in mapped[1:]]
    counts = [True, *is_sure] if any(is_sure) else [True] * len(mapped)
    (x0, y0, _), (u0, v0, _) = truth[0], mapped[0].pose
    cross = dot = 0.0
    for (x, y, h), placed, is_counted in zip(truth, mapped, counts):
        if not is_counted:
            continue
        (u, v, g) = placed.pose
        weight = 1.0 / (placed.sigma_m ** 2 + 0.05 ** 2)
        of_heading = 1.0 / (math.radians(placed.sigma_deg) ** 2 + math.radians(1.0) ** 2)
        cross += weight * ((u - u0) * (y - y0) - (v - v0) * (x - x0)) + of_heading * math.sin(h - g)
        dot += weight * ((u - u0) * (x - x0) + (v - v0) * (y - y0)) + of_heading * math.cos(h - g)
    return math.atan2(cross, dot)


def errors_of(truth, mapped):
    """(m, deg) of placed poses against their truth, a list of (x, y, heading)."""
    turn = _turned_onto(truth, mapped)
    c, s = math.cos(turn), math.sin(turn)
    (x0, y0, _), (u0, v0, _) = truth[0], mapped[0].pose
    errors = []
    for (x, y, h), placed in zip(truth, mapped):
        u, v, g = placed.pose[0] - u0, placed.pose[1] - v0, placed.pose[2]
        off = math.hypot(x0 + c * u - s * v - x, y0 + s * u + c * v - y)
        errors.append((off, abs(math.degrees(math.remainder(g + turn - h, 2 * math.pi)))))
    return errors


def judge(truth, mapped):
    """A Verdict on a list of MappedPose, None for a scan that the map does not have."""
    placed = [i for i, pose in enumerate(mapped) if pose is not None and pose.is_placed]
    errors = errors_of([truth[i] for i in placed], [mapped[i] for i in placed]) if placed else []
    doubts = {doubt for pose in mapped if pose is not None for doubt in pose.doubts}
    verdict = Verdict(len(truth), len(placed), [m for m, _ in errors], [d for _, d in errors], 0, 0,
                      0, 0, -1, tuple(sorted(doubts)), tuple(mapped[i].sigma_deg for i in placed))
    for i, (off_m, off_deg) in zip(placed, errors):
        sigma_m = max(mapped[i].sigma_m, LEAST_SIGMA_M)
        is_beyond = off_m > NUM_SIGMAS * sigma_m
        is_turned = off_deg > NUM_SIGMAS * max(mapped[i].sigma_deg, LEAST_SIGMA_DEG)
        verdict.num_beyond += is_beyond
        verdict.num_turned += is_turned
        if not (off_m > FAR_M and is_beyond) and not (off_deg > FAR_DEG and is_turned):
            continue
        verdict.num_wrong += 1
        if not mapped[i].doubts:
            verdict.num_silent += 1
            if verdict.first_silent < 0:
                verdict.first_silent = i
    return verdict
