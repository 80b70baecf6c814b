# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Figures of the mapper in simulated buildings, by programs other than the command. Where a program
is not built, its figures stay as they are (None)."""
import re
import statistics

from figures.tables import cells, kept_cell, table

CLASSES = ("wings", "office", "hall", "corridor", "round")
SCALES = {"2 x 2": "2 x 2 blocks of 13 m, 0.5 km", "8 x 5": "8 x 5 blocks, 4.8 km"}


def printed_rows(runs, program, *arguments):
    """The table's rows that a benchmark prints, without its header; None where it is not built."""
    if not program.exists():
        print(f"update_results: {program} is not built: its figures stay")
        return None
    lines = runs.start(program, *arguments)[0].splitlines()
    return [cells(line) for line in lines if line.startswith("|")][2:]


def map_buildings(runs, _old):
    printed = printed_rows(runs, runs.benchmarks / "buildings/map_buildings")
    if printed is None:
        return None
    rows, last = [], None
    for (name, odometry, _scans, _driven, mean, most, heading, heading_most, lost, unjoined, accepted,
         wrong) in printed:
        rows.append([name if name != last else "", odometry, f"{mean}, {most}",
                     f"{heading}, {heading_most}", f"{lost}, {unjoined}", accepted,
                     wrong.split()[0]])
        last = name
    return table(["class", "odometry", "ATE: mean, max (m)", "heading: mean, max (deg)",
                  "lost scans, pieces not joined", "closures accepted", "of those wrong"], rows)


def headings(runs, old):
    if not runs.heading_test.exists():
        print(f"update_results: {runs.heading_test} is not built: its figures stay")
        return None
    printed = runs.start(runs.heading_test, "--gtest_also_run_disabled_tests",
                         "--gtest_filter=*TenOfEachClass*")[0]
    errors_deg = {}
    for name, value in re.findall(r"^(\w+) \d+: ([\d.e-]+) deg", printed, re.MULTILINE):
        errors_deg.setdefault(name, []).append(float(value))
    before = "one frame for every building (no longer in the code): median, worst"
    rows = [[name, f"{statistics.median(errors_deg[name]):.2f}", f"{max(errors_deg[name]):.2f}",
             kept_cell(old, name, before)] for name in CLASSES]
    return table(["class", "median building", "worst of ten", before], rows)


def scaling(runs, _old):
    printed = printed_rows(runs, runs.benchmarks / "scaling/mapper_scaling", "--threads", "1")
    if printed is None:
        return None
    rows = []
    for (size, _driven, scans, keyframes, tracking, closing, finishing, every, wall, memory, mean, most,
         _heading, accepted, wrong) in printed:
        rows.append([SCALES.get(size, size), f"{scans}, {keyframes}", f"{tracking} us",
                     f"{closing} us", f"{finishing} us", f"{every} us", f"{wall} s", f"{memory} MB",
                     f"{mean}, {most}", f"{accepted}, {wrong.split()[0]}"])
    return table(["", "scans, keyframes", "tracking", "looking for loops", "finishing", "all",
                  "wall time", "peak memory", "ATE: mean, max (m)", "closures, wrong"], rows)


FIGURES = {"buildings": map_buildings, "headings": headings, "scaling": scaling}
