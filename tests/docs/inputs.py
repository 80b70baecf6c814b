# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Small files under the names that the pages use, all made from simulated logs with their truth."""
import json
import math
import shutil
import subprocess

# In a page's folder from its beginning: links to what was made once.
NAMES = ["log.clf", "intel.clf", "robot.mcap", "my_bag", "flat.txt", "logs", "monday.mcap", "tuesday.mcap", "east_wing", "west_wing",
         "truth.tum", "truth.relations", "intel.relations", "intel.local.relations"]


def _relations(truth, step):
    """Each pose seen from the one STEP poses before, as lines of relations."""
    poses = [[float(text) for text in line.split()] for line in truth.read_text().splitlines()]
    lines = []
    for earlier, later in list(zip(poses, poses[step:]))[::step]:
        heading = 2.0 * math.atan2(earlier[6], earlier[7])
        turn = math.remainder(2.0 * math.atan2(later[6], later[7]) - heading, math.tau)
        dx, dy = later[1] - earlier[1], later[2] - earlier[2]
        ahead = math.cos(heading) * dx + math.sin(heading) * dy
        left = math.cos(heading) * dy - math.sin(heading) * dx
        lines.append(f"{earlier[0]:.6f} {later[0]:.6f} {ahead:.6f} {left:.6f} 0 0 0 {turn:.6f}\n")
    return "".join(lines)


def _printed_by_rplidar(log):
    """The scans of JSON lines as RPLIDAR's demonstration program prints them: clockwise, in mm."""
    lines = []
    for line in log.read_text().splitlines():
        record = json.loads(line)
        if "ranges" not in record:
            continue
        beams = []
        for beam, range_m in enumerate(record["ranges"]):
            angle = record["angle_min"] + beam * record["angle_step"]
            known = isinstance(range_m, (int, float)) and math.isfinite(range_m)
            beams.append((-math.degrees(angle) % 360.0, 1000.0 * range_m if known else 0.0))
        for number, (angle_deg, range_mm) in enumerate(sorted(beams)):
            mark = "S " if number == 0 else "  "
            lines.append(f"{mark} theta: {angle_deg:05.2f} Dist: {range_mm:08.2f} Q: 47\n")
    return "".join(lines)


def make(command, folder):
    """Makes all of NAMES in FOLDER."""
    def run(*arguments):
        subprocess.run([command, *arguments], cwd=folder, check=True, capture_output=True)
    folder.mkdir(parents=True)
    run("simulate", "--building", "office", "--seed", "7", "--every", "0.2", "-o", "sim")
    run("simulate", "--building", "office", "--seed", "7", "--scanner", "low-cost-360", "--rate", "5.5",
        "--format", "jsonl", "-o", "flat")
    run("convert", "sim/scans.clf", "robot.mcap")
    for name in ("log.clf", "intel.clf"):
        shutil.copy(folder / "sim/scans.clf", folder / name)
    (folder / "my_bag").mkdir()
    shutil.copy(folder / "robot.mcap", folder / "my_bag/my_bag_0.mcap")
    (folder / "logs").mkdir()
    for name in ("monday", "tuesday"):
        shutil.copy(folder / "sim/scans.clf", folder / f"logs/{name}.clf")
        shutil.copy(folder / "robot.mcap", folder / f"{name}.mcap")
    run("map", "log.clf", "-o", "east_wing")
    shutil.copytree(folder / "east_wing", folder / "west_wing")
    shutil.copy(folder / "sim/truth.tum", folder / "truth.tum")
    for name, step in (("truth.relations", 10), ("intel.relations", 10), ("intel.local.relations", 2)):
        (folder / name).write_text(_relations(folder / "truth.tum", step))
    (folder / "flat.txt").write_text(_printed_by_rplidar(folder / "flat/scans.jsonl"))


def give(made, folder):
    """Copies them to where a page's snippets run."""
    folder.mkdir(parents=True)
    for name in NAMES:
        source = made / name
        if source.is_dir():
            shutil.copytree(source, folder / name)
        else:
            shutil.copy(source, folder / name)
