# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Tables of what became of logs, dictionaries as outcome_of makes them."""
import math
import statistics

from figures.tables import table

HEADER = ["kind", "logs", "wrong and silent", "wrong, but told", "beyond 3 sigma",
          "heading beyond 3 sigma", "median error", "placed", "with a doubt"]
HEADER_OF_HEADINGS = ["kind", "level", "logs", "beyond 3 sigma", "mean square over sigma^2", "median sigma",
                      "median error"]


def _percent(part, whole):
    return f"{100 * part / whole:.1f} %" if whole else "-"


def _row_of(name, logs):
    total = {key: sum(log[key] for log in logs) for key in ("poses", "placed", "beyond", "turned")}
    medians = [log["median_m"] for log in logs if log.get("median_m") is not None]
    return [name, len(logs), sum(log["silent"] > 0 for log in logs),
            sum(log["silent"] == 0 and log["wrong"] > 0 for log in logs),
            _percent(total["beyond"], total["placed"]), _percent(total["turned"], total["placed"]),
            f"{statistics.median(medians):.3f} m" if medians else "-",
            _percent(total["placed"], total["poses"]), sum(bool(log["doubts"]) for log in logs)]


def printed_table(logs):
    kinds = list(dict.fromkeys(log["kind"] for log in logs))
    rows = [_row_of(kind, [log for log in logs if log["kind"] == kind]) for kind in kinds]
    return table(HEADER, [*rows, _row_of("all", logs)])


def _row_of_headings(kind, level, logs):
    total = {key: sum(log.get(key, 0) for log in logs) for key in ("placed", "turned", "heading_squares")}
    medians = [statistics.median(values) if values else math.nan for values in (
        [log[key] for log in logs if log.get(key) is not None]
        for key in ("heading_sigma_deg", "heading_median_deg"))]
    square = total["heading_squares"] / total["placed"] if total["placed"] else math.nan
    return [kind, level, len(logs), _percent(total["turned"], total["placed"]), f"{square:.2f}",
            *(f"{median:.2f} deg" for median in medians)]


def table_of_headings(logs):
    """How honest the spreads of the headings are, a row per level; medians are of the logs' medians."""
    groups = {}
    for log in logs:
        groups.setdefault((log["kind"], log["level"]), []).append(log)
    return table(HEADER_OF_HEADINGS, [_row_of_headings(*key, group) for key, group in groups.items()])


def silent_logs(logs):
    """A line for each log that is wrong and silent, to find it again."""
    def line(log):
        where = f"{log['log']}, " if "log" in log else ""
        return (f"{where}{log['kind']}, {log['level']}, seed {log['seed']}: {log['silent']} of {log['poses']} "
                f"poses, worst {log['worst_m']:.2f} m, {log['worst_deg']:.1f} deg")
    return [line(log) for log in logs if log["silent"] > 0]


def changed_logs(before, now):
    """A line for each log of both that has other numbers of wrong or of silent poses than before, and
    one of the sums."""
    def name(log):
        return (log.get("log", ""), log["kind"], log["level"], log["seed"])
    old = {name(log): log for log in before}
    both = [(old[name(log)], log) for log in now if name(log) in old]
    lines = [f"{', '.join(map(str, name(new)))}: wrong {a['wrong']} -> {new['wrong']}, silent "
             f"{a['silent']} -> {new['silent']}, placed {a['placed']} -> {new['placed']}" for a, new in both
             if (a["wrong"], a["silent"]) != (new["wrong"], new["silent"])]
    sums = [f"{key} {sum(a[key] for a, _ in both)} -> {sum(new[key] for _, new in both)}"
            for key in ("placed", "wrong", "silent")]
    silent = [sum(log["silent"] > 0 for log in logs) for logs in zip(*both)] if both else [0, 0]
    return [*lines, f"{len(both)} logs: {', '.join(sums)}; silent logs {silent[0]} -> {silent[1]}"]
