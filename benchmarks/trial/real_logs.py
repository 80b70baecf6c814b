# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Faults put into real logs. The truth is the map of the log as it is, with its odometry: a fault is
judged by what it changes, not by what that map lacks. Only scans that have a place in it take part."""
import dataclasses
import json
import pathlib
import random

from trial import faults
from trial.outputs import mapped_poses
from trial.trials import outcome_of, run, trial_folder, write_log

# What is done to the scans: mapped with the odometry and without.
OF_SCANS = {
    "as it is": (), "sight 4 m": (faults.short_sight(4.0, 0.02),), "sight 8 m": (faults.short_sight(8.0),),
    "every 2nd beam": (faults.every_beam(2),), "every 5th beam": (faults.every_beam(5),),
    "120 deg": (faults.field_of_view(120.0),), "90 deg": (faults.field_of_view(90.0),),
    "noise 2 cm": (faults.noisy(0.02),), "noise 5 cm": (faults.noisy(0.05),),
    "half missing": (faults.missing(0.5),), "glass": (faults.glass(0.3),),
    "dust 5 %": (faults.dust(0.05),), "dust 15 %": (faults.dust(0.15),),
    "people 3": (faults.people(3),), "people 8": (faults.people(8),),
    "posts 4": (faults.posts(4, 12.0),), "each twice": (faults.sent_again(2),),
    "each five times": (faults.sent_again(5),), "every 3rd scan": (faults.every_scan(3),),
    "every 8th scan": (faults.every_scan(8),), "key frames": (faults.key_frames(1.0, 30.0),),
    **{f"{way_m:g} m or {turn_deg:g} deg": (faults.uneven_key_frames(way_m, turn_deg),)
       for way_m, turn_deg in ((1.0, 30.0), (1.0, 45.0), (1.5, 60.0), (2.0, 40.0))},
    "paused 5 s": (faults.paused(5.0),), "stuck 3 s": (faults.stuck(3.0),),
}
# What is done to the odometry.
OF_ODOMETRY = {
    "zero": (faults.odometry_zero,), "frozen": (faults.odometry_frozen(0.3),),
    "mirrored": (faults.odometry_mirrored,), "way x 0.8": (faults.odometry_scaled(0.8),),
    "way x 1.5": (faults.odometry_scaled(1.5),), "turns x 0.5": (faults.odometry_scaled(1.0, 0.5),),
    "turns x 1.3": (faults.odometry_scaled(1.0, 1.3),), "jump 20 m": (faults.odometry_jump(20.0),),
    "delayed 1 s": (faults.odometry_delayed(1.0),), "carried and seen": (faults.carried(2.0, True),),
    "carried unseen": (faults.carried(3.0, False),),
}
FAULTS = {**OF_SCANS, **OF_ODOMETRY}


@dataclasses.dataclass(frozen=True)
class RealTrial:
    """`log`: its file; `level` is the mode: "odometry" or "alone"."""
    log: pathlib.Path
    fault: str
    mode: str
    seed: int


def real_trials(logs, names, seeds):
    return [RealTrial(log, name, mode, seed) for log in logs for name in names for seed in seeds
            for mode in (("odometry", "alone") if name in OF_SCANS else ("odometry",))]


def base_of(command, log, folder):
    """Maps a log as it is, and writes its scans with their truth to folder/base.jsonl. Returns what the map doubts of itself."""
    folder.mkdir(parents=True, exist_ok=True)
    for step in (("convert", log, folder / "log.jsonl"),
                 ("map", log, "--frame", "sensor", "-o", folder / "map")):
        done = run(command, *step)
        if done.returncode != 0:
            raise RuntimeError(f"{step[0]} {log}: {done.stderr}")
    mapped, record = mapped_poses(folder / "map")
    last_s = float("-inf")
    with open(folder / "log.jsonl", encoding="ascii") as lines, \
            open(folder / "base.jsonl", "w", encoding="ascii") as base:
        for line in lines:
            scan = json.loads(line)
            pose = mapped.get(f"{scan['stamp']:.6f}") if "ranges" in scan else None
            if pose is None or not pose.is_placed or scan["stamp"] <= last_s:
                continue
            last_s = scan["stamp"]
            base.write(json.dumps({**scan, "truth": pose.pose}) + "\n")
    return ", ".join(f"{doubt['kind']} (scans {doubt['first_scan']} on)" for doubt in record["doubts"])


def run_real_trial(command, trial, base, keep=None):
    """What became of it, for JSON. `base`: the folder that base_of filled."""
    name = f"{trial.fault}-{trial.mode}-{trial.seed}".replace(" ", "_")
    with trial_folder(keep, f"{trial.log.stem}/{name}") as folder:
        with open(base / "base.jsonl", encoding="ascii") as lines:
            scans = [json.loads(line) for line in lines]
        draw = random.Random(trial.seed)
        for fault in FAULTS[trial.fault]:
            scans = fault(scans, draw)
        write_log(scans, folder / "log.jsonl")
        options = ("--frame", "sensor", *(("--no-odometry",) if trial.mode == "alone" else ()))
        return {"log": trial.log.stem, "kind": trial.fault, "level": trial.mode, "seed": trial.seed,
                **outcome_of(command, scans, options, folder)}
