# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Figures of the three real logs: whole logs, loop closures, pairs of scans."""
from figures.runs import LOGS
from figures.tables import kept_cell, table

# What others reach: constants, never rerun here. The first row is printed in Hess, Kohler, Rapp and
# Andor, "Real-time loop closure in 2D LIDAR SLAM", ICRA 2016, with its time. The other rows were
# measured by this project on the same logs and relations when the README got them (commit 00d84cf).
# "Mended": fr079's odometry turned the right way by hand.
PEERS = [
    ["Cartographer, published 2016 (tuned for each log)",
     "0.0229 / 0.453", "0.0375 / 0.373", "0.0452 / 0.538", "179 s (2016)"],
    ["Cartographer, correlative front end, with odometry",
     "0.0233 / 0.435", "1.01 / 1.4", "0.0390 / 0.565 (odometry mended)", "552 s"],
    ["Cartographer, stock 2-D configuration, no odometry", "20.2 / 45", "2.0 / 10", "-", "10 s"],
    ["Karto, default, with odometry",
     "0.0221 / 0.697", "0.0473 / 0.707", "0.0409 / 1.25 (odometry mended)", "236 s"],
    ["GMapping, 30 particles, with odometry",
     "0.0329 / 1.28", "0.098 / 0.83", "0.0514 / 2.1 (odometry mended)", "308 s"],
]
ODOMETRY = {True: "with odometry", False: "odometry ignored"}


def error(relations, part="all"):
    return (f"{relations[part]['translation_m']['mean']:.4f} / "
            f"{relations[part]['rotation_deg']['mean']:.3f}")


def whole_logs(runs, _old):
    times_s = runs.map_times_s("intel")
    rows = [[f"**Setsquare, {ODOMETRY[odometry]}**",
             *(error(runs.relations(log, odometry)) for log in LOGS),
             f"{times_s[odometry]:.1f} s"] for odometry in (False, True)]
    return table(["", *LOGS, "time for intel"], rows + PEERS)


def relations(runs, _old):
    rows = []
    for log in LOGS:
        for odometry in (True, False):
            found = runs.relations(log, odometry)
            rows.append([log, "yes" if odometry else "no", error(found),
                         error(found, "under_60_s"), error(found, "from_60_s")])
    return table(["log", "odometry", "all relations", "under 60 s apart", "60 s and more"], rows)


def closures(runs, _old):
    rows = []
    for log in LOGS:
        for odometry in (True, False):
            accepted = runs.closures(log, odometry)["accepted"]
            rows.append([log, "yes" if odometry else "no", accepted["num_closures"],
                         accepted["num_judged"], accepted["num_right"], accepted["num_wrong"],
                         accepted["num_borderline"], accepted["num_disputed"]])
    return table(["log", "odometry", "accepted", "judged", "right", "wrong", "borderline",
                  "disputed"], rows)


def chains(runs, _old):
    rows = []
    for log in LOGS:
        found = runs.chains(log)
        metres, degrees = found["translation_m"], found["rotation_deg"]
        rows.append([log, found["num_closures"], found["num_right"], found["num_wrong"],
                     found["num_borderline"], found["num_disputed"], found["num_unjudged"],
                     f"{metres['median']:.3f}, {metres['max']:.2f} m; "
                     f"{degrees['median']:.2f}, {degrees['max']:.1f} deg"])
    return table(["relations", "60 s and more", "right", "wrong", "borderline", "disputed",
                  "out of reach", "chain's error: median, max"], rows)


def pair_cell(summary):
    found = summary["all"]
    return f"{found['success']:.1f} / {found['tight']:.1f}; {found['time_us'] / 1000:.2f} ms"


def pairs(runs, old):
    peers = ["MRPT ICP, classic", "MRPT ICP, Levenberg-Marquardt"]
    rows = []
    for log in LOGS:
        for kind in ("local", "loop"):
            label = f"{log} {kind}"
            rows.append([label, *(kept_cell(old, label, peer) for peer in peers),
                         pair_cell(runs.pairs(log, kind, "paper")),
                         pair_cell(runs.pairs(log, kind))])
    return table(["pairs", *peers, "Setsquare, `--preset paper`", "Setsquare"], rows)


def joined(summaries, key):
    return " / ".join(f"{each[key]:g}" for each in summaries)


def pairs_by_overlap(runs, _old):
    rows = []
    for log in LOGS:
        found = runs.pairs(log, "local")["all"]
        rows.append([f"{log} local",
                     *(f"{found[key]:g}" for key in ("number", "success", "tight", "matched",
                                                     "wrong"))])
    loops = [runs.pairs(log, "loop") for log in LOGS]
    for name in ("overlap >= 45 %", "overlap 20-45 %", "overlap < 20 %"):
        parts = [loop[name] for loop in loops]
        rows.append([f"loops, {name}: {' / '.join(LOGS)}",
                     *(joined(parts, key) for key in ("number", "success", "tight", "matched",
                                                      "wrong"))])
    return table(["pairs", "number", "success %", "tight %", "matched %", "wrong"], rows)


def count(found, key):
    return round(found["number"] * found[key] / 100)


def pairs_summary(runs, _old):
    """The sentence that sums up pairs and pairs-by-overlap."""
    everything = [runs.pairs(log, kind)["all"] for log in LOGS for kind in ("local", "loop")]
    high = [runs.pairs(log, "loop")["overlap >= 45 %"] for log in LOGS]
    return (f"Answered `matched`: {sum(count(each, 'matched') for each in everything)}, of these "
            f"wrong: {sum(each['wrong'] for each in everything)}. Loops with an overlap of 45 % and "
            f"more: {sum(count(each, 'success') for each in high)} of "
            f"{sum(each['number'] for each in high)} succeed.")


def pairs_paper(runs, old):
    squared = ["omega^2: success / tight / matched %", "wrong with omega^2"]
    rows = []
    for kind in ("local", "loop"):
        for log in LOGS:
            label = f"{log} {kind}"
            found = runs.pairs(log, kind, "paper")["all"]
            rows.append([label,
                         f"{found['success']:.1f} / {found['tight']:.1f} / {found['matched']:.1f}",
                         found["wrong"], *(kept_cell(old, label, name) for name in squared)])
    return table(["pairs", "neighbour differences (preset): success / tight / matched %", "wrong",
                  *squared], rows)


FIGURES = {
    "whole-logs": whole_logs,
    "relations": relations,
    "closures": closures,
    "chains": chains,
    "pairs": pairs,
    "pairs-by-overlap": pairs_by_overlap,
    "pairs-summary": pairs_summary,
    "pairs-paper": pairs_paper,
}
