# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""The kinds of trouble of the trial ground: what is simulated, what goes wrong, how it is mapped."""
import dataclasses

from trial import faults, plans

BUILDINGS = ("office", "hall", "wings", "corridor", "round")
UTM = ("--scanner", "utm-30lx", "--beams", "361", "--speed", "0.8")
SICK = ("--scanner", "utm-30lx", "--beams", "181", "--field-of-view", "180", "--speed", "0.8")
LOW_COST = ("--scanner", "low-cost-360", "--speed", "0.8")
WITHOUT = ("--no-odometry",)


@dataclasses.dataclass(frozen=True)
class Level:
    """One severity of a kind. `plan`, a function of the seed that returns an SVG, replaces the
    buildings, which take turns by seed and level; the faults are applied in their order."""
    name: str
    simulate: tuple = UTM
    buildings: tuple = BUILDINGS
    plan: object = None
    faults: tuple = ()
    map: tuple = ()


def _corridors():
    bare, doors = plans.corridor, lambda seed: plans.corridor(seed, 10.0)
    back = lambda seed: plans.corridor(seed, None, True)  # noqa: E731 (a name for the table below)
    near = faults.short_sight(8.0)

    def level(name, plan, *more):
        return Level(name, SICK, plan=plan, faults=(near, *more), map=WITHOUT)
    return {
        "corridor-bare": (level("no doors", bare), level("doors every 10 m", doors),
                          level("there and back", back), level("ring", plans.ring)),
        "corridor-stop": (level("once 3 s", bare, faults.stops(1, 3.0)),
                          level("three times 5 s", bare, faults.stops(3, 5.0)),
                          level("doors, three times 3 s", doors, faults.stops(3, 3.0))),
    }


def _rings():
    """Loops through bare corridors, and places that only look like loops."""
    slow = (*SICK[:-1], "0.6")
    spoilt = (faults.short_sight(8.0), faults.uneven_speed(2), faults.stops(4, 4.0))

    def level(name, plan):
        return Level(name, slow, plan=plan, faults=spoilt, map=WITHOUT)
    return {
        "ring-of-rooms": (level("30 m", lambda seed: plans.ring_of_rooms(seed, 31.0)),
                          level("30 to 60 m", plans.ring_of_rooms)),
        "twins": (level("one room, spiral", plans.spiral_of_twins),
                  level("two rooms, spiral", lambda seed: plans.spiral_of_twins(seed, 2)),
                  level("row", plans.row_of_twins), level("corridors", plans.twin_corridors)),
    }


def _round_halls():
    hall = plans.round_hall
    return {
        "round-odometry": (
            Level("exact", (*LOW_COST, "--no-odometry-drift"), plan=hall),
            Level("drifting", LOW_COST, plan=hall),
            Level("exact, 270 deg", (*UTM, "--no-odometry-drift"), plan=hall)),
        "round-alone": (Level("360 deg", LOW_COST, plan=hall, map=WITHOUT),
                        Level("270 deg", UTM, plan=hall, map=WITHOUT)),
    }


def _wings():
    def plan(seed):
        return plans.oblique_wings(seed, 5 + seed % 10)
    return {"wings-5-to-14-deg": (Level("270 deg", UTM, plan=plan, map=WITHOUT),
                                  Level("360 deg, 8 m", LOW_COST, plan=plan, map=WITHOUT),
                                  Level("180 deg", SICK, plan=plan, map=WITHOUT))}


def _sparse():
    every = ("--every", "1", "--every-angle", "30")
    return {"key-frames": (Level("270 deg, 30 m", (*UTM, *every), map=WITHOUT),
                           Level("180 deg", (*SICK, *every), map=WITHOUT),
                           Level("360 deg, 8 m", (*LOW_COST, *every), map=WITHOUT))}


def _turns():
    def level(rate, turn, options, name):
        simulate = (*LOW_COST, "--spin", "360", "--turn-rate", str(turn), "--rate", str(rate))
        return Level(f"{turn} deg/s, {rate} Hz, {name}", simulate, map=options)
    poor = (faults.short_sight(4.0, 0.02),)
    fast = (*LOW_COST, "--beams", "180", "--rate", "7", "--turn-rate")
    return {
        "turn-on-the-spot": tuple(
            level(rate, turn, options, name) for rate, turn in ((7, 90), (10, 180), (10, 250))
            for options, name in (((), "odometry"), (WITHOUT, "alone"))),
        "poor-lidar": tuple(
            Level(f"{turn} deg/s, {name}", (*fast, str(turn)), faults=poor, map=options)
            for turn in (60, 180) for options, name in (((), "odometry"), (WITHOUT, "alone"))),
    }


def _odometry():
    def kind(simulate=UTM, **of_level):
        return tuple(Level(name.replace("_", " "), simulate, faults=(fault,))
                     for name, fault in of_level.items())
    return {
        "odometry-zero": kind(all=faults.odometry_zero) +
                         (Level("all, 8 m", LOW_COST, faults=(faults.odometry_zero,)),),
        "odometry-frozen": kind(from_a_third_on=faults.odometry_frozen(1 / 3),
                                from_two_thirds_on=faults.odometry_frozen(2 / 3)),
        "odometry-mirrored": kind(odometry=faults.odometry_mirrored, scans=faults.scans_mirrored),
        "odometry-scale": kind(way_0_8=faults.odometry_scaled(0.8),
                               way_1_5=faults.odometry_scaled(1.5),
                               turn_1_3=faults.odometry_scaled(1.0, 1.3)),
        "odometry-jump": kind(once_1e22_m=faults.odometry_jump(1e22),
                              once_20_m=faults.odometry_jump(20.0)),
        "odometry-delayed": kind(by_0_3_s=faults.odometry_delayed(0.3),
                                 by_1_s=faults.odometry_delayed(1.0)),
        "carried": kind(seen_2_m=faults.carried(2.0, True), unseen_3_m=faults.carried(3.0, False)),
    }


def _scans():
    few = (*LOW_COST, "--beams")
    return {
        "paused": (Level("5 s, odometry", faults=(faults.paused(5.0),)),
                   Level("5 s, alone", faults=(faults.paused(5.0),), map=WITHOUT),
                   Level("20 s, alone", faults=(faults.paused(20.0),), map=WITHOUT)),
        "posts": (Level("3 of 3 deg", faults=(faults.posts(3, 3.0),)),
                  Level("4 of 12 deg, alone", LOW_COST, faults=(faults.posts(4, 12.0),), map=WITHOUT)),
        "repeated": (Level("each twice", SICK, faults=(faults.sent_again(2),)),
                     Level("each five times, alone", SICK, faults=(faults.sent_again(5),), map=WITHOUT),
                     Level("stuck for 3 s", SICK, faults=(faults.stuck(3.0),))),
        "dust": (Level("5 %", faults=(faults.dust(0.05),)),
                 Level("5 %, alone", faults=(faults.dust(0.05),), map=WITHOUT),
                 Level("15 %, alone", LOW_COST, faults=(faults.dust(0.15),), map=WITHOUT)),
        "beams-16": (Level("odometry", (*few, "16")), Level("alone", (*few, "16"), map=WITHOUT)),
        "beams-8": (Level("odometry", (*few, "8")), Level("alone", (*few, "8"), map=WITHOUT)),
    }


def _plain():
    return {"plain": (Level("270 deg"), Level("270 deg, alone", map=WITHOUT),
                      Level("360 deg, 8 m, alone", LOW_COST, map=WITHOUT))}


KINDS = {**_plain(), **_corridors(), **_rings(), **_round_halls(), **_wings(), **_sparse(), **_turns(), **_odometry(),
         **_scans()}
