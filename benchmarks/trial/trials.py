# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""One trial: a log is simulated, spoilt, mapped and judged."""
import contextlib
import dataclasses
import json
import pathlib
import random
import subprocess
import tempfile

from trial.judge import judge
from trial.kinds import KINDS
from trial.outputs import mapped_poses, poses_of


@dataclasses.dataclass(frozen=True)
class Trial:
    kind: str
    level: int
    seed: int

    @property
    def name(self):
        return f"{self.kind} ({KINDS[self.kind][self.level].name}) {self.seed}"


def trials_of(kinds, seeds):
    return [Trial(kind, level, seed) for kind in kinds for level in range(len(KINDS[kind]))
            for seed in seeds]


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)


def _simulated(command, trial, folder):
    """The scans of a trial's log before anything goes wrong, each with its truth."""
    level, seed = KINDS[trial.kind][trial.level], trial.seed
    if level.plan:
        (folder / "plan.svg").write_text(level.plan(seed))
        where = ("--plan", folder / "plan.svg")
    else:
        where = ("--building", level.buildings[(seed + trial.level) % len(level.buildings)])
    done = run(command, "simulate", *where, "--seed", seed, *level.simulate, "--format", "jsonl",
                "-o", folder / "sim")
    if done.returncode != 0:
        raise RuntimeError(f"simulate: {done.stderr}")
    with open(folder / "sim/scans.jsonl", encoding="ascii") as lines:
        records = [json.loads(line) for line in lines]
    scans = [record for record in records if "ranges" in record]
    truth = poses_of(folder / "sim/truth.tum")
    return [{**scan, "truth": pose} for scan, (_, pose) in zip(scans, truth, strict=True)]


def spoilt_log(command, trial, folder):
    """Writes folder/log.jsonl, in which nothing tells the truth; returns its scans."""
    level = KINDS[trial.kind][trial.level]
    scans = _simulated(command, trial, folder)
    draw = random.Random(trial.seed)
    for fault in level.faults:
        scans = fault(scans, draw)
    write_log(scans, folder / "log.jsonl")
    return scans


def write_log(scans, path):
    """A log of the scans, without their truth."""
    with open(path, "w", encoding="ascii") as log:
        for scan in scans:
            seen = {key: value for key, value in scan.items() if key not in ("truth", "true_pose")}
            log.write(json.dumps({**seen, "stamp": round(scan["stamp"], 6)}) + "\n")


def judged(scans, mapped):
    """The verdict on the scans of a log by what the map says of each stamp."""
    return judge([scan["truth"] for scan in scans],
                 [mapped.get(f"{scan['stamp']:.6f}") for scan in scans])


def outcome_of(command, scans, options, folder):
    """Maps folder/log.jsonl, the log of the scans, and judges the map."""
    done = run(command, "map", folder / "log.jsonl", "--threads", 1, *options, "-o", folder / "map")
    if done.returncode != 0:
        return {"poses": len(scans), "placed": 0, "silent": 0, "wrong": 0, "beyond": 0, "turned": 0,
                "doubts": ["no map"], "error": done.stderr.strip()}
    mapped, record = mapped_poses(folder / "map")
    return {**judged(scans, mapped).as_json(),
            "pieces": len(record["pieces"]), "status": record["num"],
            "open_stretches": len(record["open_stretches"]),
            "findings": [finding["kind"] for finding in record["findings"]]}


@contextlib.contextmanager
def trial_folder(keep, name):
    """keep/name, which stays; a temporary folder where `keep` is None."""
    if keep is not None:
        folder = keep / name
        folder.mkdir(parents=True, exist_ok=True)
        yield folder
        return
    with tempfile.TemporaryDirectory(prefix="setsquare-trial-") as temporary:
        yield pathlib.Path(temporary)


def run_trial(command, trial, keep=None):
    """What became of it, for JSON. `keep`: a folder in which log and map stay."""
    with trial_folder(keep, f"{trial.kind}-{trial.level}-{trial.seed}") as folder:
        scans = spoilt_log(command, trial, folder)
        level = KINDS[trial.kind][trial.level]
        return {"kind": trial.kind, "level": level.name, "seed": trial.seed,
                **outcome_of(command, scans, level.map, folder)}
