# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Figures of `setsquare experiment paper`, out of its paper.json. Where it was built without MRPT the
rows and cells of MRPT's ICP stay as the document has them."""
import re
import statistics

from figures.tables import kept_cell, kept_row, table

HIGH = "determined_overlap_45_and_more"
MIDDLE = "determined_overlap_30_to_45"
CHAINS = ("paper_literal", "paper", "default", "full_mapper")


def percent(tally, digits=1):
    return f"{100 * tally['success_share']:.{digits}f} %"


def of(part, tally, total="num_pairs"):
    return f"{tally[part]} of {tally[total]}"


def wrong_of(tally):
    return of("num_wrong", tally, "num_matched")


def millimetres(tally):
    if tally["success_error_m"] is None:
        return "-"
    return (f"{1000 * tally['success_error_m']['mean']:.1f} mm, "
            f"{tally['success_error_deg']['mean']:.3f} deg")


def metres(tally):
    return f"{tally['success_error_m']['mean']:.3f} m, {tally['success_error_deg']['mean']:.2f} deg"


def hallways(runs, old):
    paper = runs.paper_json()
    rows = [["the paper, its method", "-", "all", "0.04 (0.02) m, 0.33 (0.25) deg", "17 ms (2014)"],
            ["the paper, ICP", "-", "not all", "0.07 (0.03) m, 0.51 (0.32) deg", "11 ms (2014)"]]
    for where, key in (("first hallway", "first_hallway"), ("20 hallways", "all_hallways")):
        for name, matcher in (("MRPT's ICP", "mrpt_icp"), ("`--preset paper`", "paper"),
                              ("default", "default")):
            label = f"{where}, {name}"
            found = paper["section_5_1"][key][matcher]
            if isinstance(found, str):  # MRPT is not installed
                rows.append(kept_row(old, label) or [label, "-", "-", "-", "-"])
                continue
            both, high = found["all_pairs"], found[HIGH]
            metre, degree = both["success_error_m"], both["success_error_deg"]
            time_ms = paper["timing"]["a_match"][f"{matcher}_median_ms"]
            rows.append([label, of("num_success", both),
                         f"{of('num_success', high)} ({percent(high)})",
                         f"{metre['mean']:.4f} ({metre['sigma']:.4f}) m, "
                         f"{degree['mean']:.3f} ({degree['sigma']:.3f}) deg",
                         f"{time_ms:.2f} ms" if key == "first_hallway" else ""])
    return table(["", "success, all pairs", "success, overlap >= 45 %",
                  "mean error (sigma) of the successes", "a match"], rows)


def hallways_found(runs, _old):
    """The sentences under the table of hallways."""
    study = runs.paper_json()["section_5_1"]
    first, every = study["first_hallway"], study["all_hallways"]
    missed = [pair["paper"] for pair in study["pairs_of_the_first"]
              if pair["overlap"] >= 0.45 and pair["is_determined"]
              and not (pair["paper"]["error_m"] <= 0.2 and pair["paper"]["error_deg"] <= 30)]
    near = [sum(abs(pair["error_deg"] - turn_deg) <= 30 for pair in missed)
            for turn_deg in (0, 90, 180)]
    ours, theirs = every["default"]["all_pairs"], first["paper"]["all_pairs"]
    return (
        f"(Determined pairs in the column of 45 % and more; "
        f"{every['num_overlap_45_and_more_undetermined']} of that overlap are not determined. The "
        f"default's answers `matched`: {ours['num_matched']}, {ours['num_wrong']} of them wrong. "
        f"With a turn in the path the literal method misses "
        f"{100 * (1 - every['paper'][HIGH]['success_share']):.0f} % of the pairs of 45 % and more "
        f"over all seeds, {100 * (1 - first['paper'][HIGH]['success_share']):.0f} % in the first "
        f"hallway. Of the {len(missed)} that it misses there {near[1]} are off by a quarter turn, "
        f"{near[2]} by half a turn; {near[0]} have the right heading and lie on a wrong peak of an "
        f"axis. {theirs['num_wrong']} of its {theirs['num_matched']} accepted answers are wrong.)")


def classes(runs):
    return runs.paper_json()["buildings"]["by_class"]


def matched(tally):
    return f"{tally['num_matched']} ({100 * tally['matched_share']:.1f} %)"


def middle(found):
    return f"{of('num_success', found[MIDDLE])} ({percent(found[MIDDLE])})"


def buildings(runs, _old):
    rows = []
    for each in classes(runs):
        found = each["default"]
        both, high = found["all_pairs"], found[HIGH]
        rows.append([each["class"], high["num_pairs"],
                     f"{high['num_success']} ({percent(high, 2)})", middle(found), matched(both),
                     both["num_wrong"], millimetres(found["determined"]),
                     f"{both['nees_of_right']['mean']:.2f}, "
                     f"{100 * both['nees_of_right_below_7_81_share']:.1f} %"])
    return table(["class", "determined, >= 45 %", "success", "at 30-45 %",
                  "answered `matched`, all pairs", "wrong", "mean error of the successes",
                  "e^T Omega e of the right `matched`: mean, below 7.81"], rows)


def buildings_preset(runs, _old):
    rows = []
    for each in classes(runs):
        found = each["paper"]
        both, high = found["all_pairs"], found[HIGH]
        rows.append([each["class"], high["num_pairs"],
                     f"{high['num_success']} ({percent(high, 2)})", middle(found), matched(both),
                     both["num_wrong"], millimetres(found["determined"])])
    return table(["class", "determined, >= 45 %", "success", "at 30-45 %",
                  "answered `matched`, all pairs", "wrong", "mean error of the successes"], rows)


def buildings_found(runs, _old):
    """The sentences under the tables of buildings."""
    study = runs.paper_json()["buildings"]
    every = classes(runs)[-1]
    ours, theirs = every["default"], every["paper"]
    failures = [pair["answer"]["status"] for pair in study["failures_overlap_45_and_more"]]
    answers = ", ".join(f"{failures.count(status)} `{status}`"
                        for status in sorted(set(failures), key=failures.count, reverse=True))
    wrong = "; ".join(
        f"{pair['class']} seed {pair['seed']}, {pair['reference']}-{pair['current']} "
        f"({100 * pair['overlap']:.0f} % overlap, off by {pair['answer']['error_m']:.2f} m, "
        f"{pair['answer']['error_deg']:.1f} deg)" for pair in study["wrong_matched"])
    full = theirs["determined_by_overlap"][9]["tally"]
    return (
        f"The default matcher finds {ours[HIGH]['num_success']} of the {ours[HIGH]['num_pairs']} "
        f"determined pairs of 45 % and more; it answers {ours[HIGH]['num_matched']} of them "
        f"`matched`. The {len(failures)} that it misses are answered {answers}. Wrong `matched` "
        f"answers, over all {every['num_pairs']} pairs: {len(study['wrong_matched'])}"
        + (f": {wrong}" if wrong else "") + ".\n\n"
        f"The paper's method finds {theirs[HIGH]['num_success']} of these pairs, "
        f"{percent(theirs[HIGH])}, and no overlap is enough for it: between 90 and 100 % it is right "
        f"in {percent(full)}. Of its {theirs['all_pairs']['num_matched']} accepted answers "
        f"{theirs['all_pairs']['num_wrong']} are wrong.")


def difficulty(runs, _old):
    found = classes(runs)
    names = [each["class"] for each in found]
    lines = [
        ("returns from furniture, clutter, people",
         lambda each: f"{100 * each['clutter_share']['mean']:.1f} %"),
        ("pairs", lambda each: each["num_pairs"]),
        ("pairs below 60 % overlap", lambda each: f"{100 * each['share_below_60_overlap']:.1f} %"),
        ("pairs of 45 % and more", lambda each: each["num_overlap_45_and_more"]),
        ("of those, not determined",
         lambda each: f"{100 * each['num_of_those_undetermined'] / each['num_overlap_45_and_more']:.1f} %"),
    ]
    return table(["", *names], [[what, *(cell(each) for each in found)] for what, cell in lines])


def by_overlap(runs, _old):
    everything = classes(runs)[-1]
    ours, theirs = everything["default"], everything["paper"]

    def bins(found, key, cell):
        return [cell(each["tally"]) for each in found[key]]

    def success_and_matched(tally):
        return f"{100 * tally['num_matched_success'] / tally['num_pairs']:.1f} %"

    known = "determined_by_overlap"
    rows = [["pairs", *bins(ours, known, lambda tally: tally["num_pairs"])],
            ["default: success", *bins(ours, known, percent)],
            ["default: success and `matched`", *bins(ours, known, success_and_matched)],
            ["`--preset paper`: success", *bins(theirs, known, percent)],
            ["default: mean error of the successes",
             *bins(ours, known, lambda tally: millimetres(tally).split(",")[0])],
            ["wrong of `matched`, all pairs: default", *bins(ours, "all_by_overlap", wrong_of)],
            ["wrong of `matched`, all pairs: `--preset paper`",
             *bins(theirs, "all_by_overlap", wrong_of)]]
    return table(["overlap", *(f"{10 * i}-{10 * i + 10} %" for i in range(10))], rows)


def factors(runs, _old):
    rows, last = [], None
    for each in runs.paper_json()["factors"]["levels"]:
        ours, theirs = each["default"], each["paper"]
        rows.append([each["factor"] if each["factor"] != last else "", each["level"],
                     percent(ours[HIGH]), percent(ours[MIDDLE]), wrong_of(ours["all_pairs"]),
                     millimetres(ours["determined"]), percent(theirs[HIGH]),
                     wrong_of(theirs["all_pairs"])])
        last = each["factor"]
    return table(["factor", "", "default: success >= 45 %", "at 30-45 %", "wrong of `matched`",
                  "mean error", "`--preset paper`: success >= 45 %", "wrong of `matched`"], rows)


class Circuits:
    """section_5_2, by chain."""

    def __init__(self, runs):
        self.study = runs.paper_json()["section_5_2"]

    def each(self, chain, *keys):
        values = [run[chain] for run in self.study["runs"]]
        for key in keys:
            values = [value[key] for value in values]
        return values

    def median(self, chain, *keys):
        return statistics.median(abs(value) for value in self.each(chain, *keys))

    def worst(self, chain, *keys):
        return max(abs(value) for value in self.each(chain, *keys))

    def closure(self, chain, circuit):
        found = self.study["median_closure_errors"][chain]
        return (f"{found['abs_x_m'][circuit]:.3f}, {found['abs_y_m'][circuit]:.3f}; "
                f"{found['norm_m'][circuit]:.3f} m")


def circuits(runs, _old):
    found = Circuits(runs)
    num_scans = sum(run["num_scans"] - 1 for run in found.study["runs"])

    def worst_closures(chain):
        return " / ".join(f"{found.worst(chain, 'closures', c, 'norm_m'):.3f}" for c in (0, 1)) + " m"

    def scans(chain, cell):
        if chain == "full_mapper":
            return "all" if cell == "matched" else "-"
        if cell == "matched":
            return f"{sum(found.each(chain, 'scans', 'matched'))} of {num_scans}"
        return ", ".join(str(sum(found.each(chain, "scans", key)))
                         for key in ("degenerate", "ambiguous", "unmatched"))

    lines = [
        ("closure after 398 m: abs. x, y; norm, medians", "0.3, 0.8; 0.85 m",
         lambda chain: found.closure(chain, 0)),
        ("closure after 901 m", "0.5, 1.2; 1.30 m", lambda chain: found.closure(chain, 1)),
        ("worst seed, after 398 / 901 m", "-", worst_closures),
        ("heading error: mean along the track, median", '"without errors"',
         lambda chain: f"{found.median(chain, 'heading', 'mean_deg'):.3f} deg"),
        ("highest on the way: median, worst seed", "-",
         lambda chain: f"{found.median(chain, 'heading', 'max_deg'):.2f}, "
                       f"{found.worst(chain, 'heading', 'max_deg'):.2f} deg"),
        ("at the end: median, worst seed", "-",
         lambda chain: f"{found.median(chain, 'heading', 'end_deg'):.3f}, "
                       f"{found.worst(chain, 'heading', 'end_deg'):.3f} deg"),
        ("abs. slope against distance, median, worst", "-",
         lambda chain: f"{found.median(chain, 'heading', 'slope_deg_per_100_m'):.4f}, "
                       f"{found.worst(chain, 'heading', 'slope_deg_per_100_m'):.4f} deg per 100 m"),
        ("wrong turns (steps over 45 deg off), all seeds", "none",
         lambda chain: sum(found.each(chain, "heading", "num_wrong_turns"))),
        ("modulo 90 deg: mean; at the end, worst", "-",
         lambda chain: f"{found.median(chain, 'heading', 'modulo_90_deg', 'mean_deg'):.3f}; "
                       f"{found.worst(chain, 'heading', 'modulo_90_deg', 'end_deg'):.3f} deg"),
        ("scans matched", "all", lambda chain: scans(chain, "matched")),
        ("degenerate, ambiguous, unmatched", "-", lambda chain: scans(chain, "others")),
    ]
    return table(["", "the paper", "`--preset paper`, as printed", "`--preset paper`, in sequence",
                  "default", "full mapper"],
                 [[what, stated, *(cell(chain) for chain in CHAINS)] for what, stated, cell in lines])


def full_mapper(runs, _old):
    found = Circuits(runs)
    rows = []
    for name, chain in (("no odometry", "full_mapper"),
                        ("with odometry", "full_mapper_with_odometry")):
        def spread(*keys, digits=3, chain=chain):
            return f"{found.median(chain, *keys):.{digits}f}, {found.worst(chain, *keys):.{digits}f}"
        rows.append([name, spread("first_pose_aligned", "final_m"),
                     spread("first_pose_aligned", "mean_m"), spread("best_aligned", "mean_m"),
                     spread("best_aligned", "max_m"), spread("best_aligned", "heading_mean_deg"),
                     spread("best_aligned", "heading_max_deg", digits=2),
                     f"{sum(found.each(chain, 'loop_closures', 'accepted'))}, "
                     f"{sum(found.each(chain, 'loop_closures', 'wrong'))}"])
    return table(["", "first pose aligned: last pose", "mean of all poses",
                  "best rigid alignment: mean", "highest", "heading, best alignment: mean", "highest",
                  "closures accepted, wrong"], rows)


def honesty(runs, _old):
    rows = []
    for each in runs.paper_json()["honesty"]["worlds"]:
        status = each["statuses"]
        rows.append([each["world"], each["what_can_be_known"], each["num_pairs"],
                     status["matched"], status["ambiguous"], status["degenerate"],
                     f"{status['no_overlap']}, {status['too_few_points']}",
                     each["num_wrong_matched"]])
    return table(["world", "what can be known", "pairs", "matched", "ambiguous", "degenerate",
                  "no overlap, too few points", "wrong"], rows)


def norms(found, chain, digits):
    norm_m = found.study["median_closure_errors"][chain]["norm_m"]
    return ", ".join(f"{value:.{digits}f} m" for value in norm_m)


def conclusion(runs, old):
    paper = runs.paper_json()
    found = Circuits(runs)
    halls, every = paper["section_5_1"]["all_hallways"], classes(runs)[-1]
    time_ms = paper["timing"]["a_match"]
    label = {"right": "the right pose where the overlap is above 45 %",
             "icp": "more often right than ICP, without an initial value",
             "error": "errors of 0.04 m, 0.33 deg; ICP 0.07 m, 0.51 deg",
             "time": "about as fast as ICP (17 and 11 ms)"}
    rows = [[label["right"],
             f"hallways {percent(halls['paper'][HIGH])}, buildings {percent(every['paper'][HIGH])}; "
             f"default {percent(halls['default'][HIGH])} and {percent(every['default'][HIGH])}"]]
    icp = halls["mrpt_icp"]

    def peer(key, pattern, cell):
        """The figure of ICP: measured, or what the document has where MRPT is not installed."""
        if not isinstance(icp, str):
            return cell()
        found = re.search(pattern, kept_cell(old, label[key], "here"))
        return found.group(1) if found else "-"

    ours_m = metres(halls["default"]["all_pairs"])
    rows += [
        [label["icp"], f"yes: {percent(halls['paper'][HIGH])} against "
         + peer("icp", r"against ([\d.]+ %)", lambda: percent(icp[HIGH])) + " in the hallways"],
        [label["error"], f"{metres(halls['paper']['all_pairs'])}; ICP "
         + peer("error", r"ICP ([\d.]+ m, [\d.]+ deg)", lambda: metres(icp["all_pairs"]))
         + f"; default {ours_m}"],
        [label["time"], f"{time_ms['paper_median_ms']:.2f} ms, ICP "
         + peer("time", r"ICP ([\d.]+ ms)", lambda: f"{time_ms['mrpt_icp_median_ms']:.2f} ms")
         + f", default {time_ms['default_median_ms']:.2f} ms"]]
    theirs, ours = every["paper"]["all_pairs"], every["default"]["all_pairs"]
    rows += [["the correlation's value shows failures",
              f"no: {100 * theirs['wrong_share_of_matched']:.0f} % of the accepted answers in the "
              f"buildings are wrong; default {100 * ours['wrong_share_of_matched']:.3f} %"],
             ["the rotation does not accumulate errors",
              "yes modulo a quarter turn; altogether only with the nearest offset"],
             ["0.85 m after 398 m, 1.30 m after 901 m",
              f"{norms(found, 'paper', 1)}; default {norms(found, 'default', 2)}; "
              f"full mapper {norms(found, 'full_mapper', 3)}"]]
    return table(["the paper", "here"], rows)


def goals(runs, _old):
    rows = []
    for goal in runs.paper_json()["goals"]:
        meets_aim = goal.get("meets_aim") and goal["aim"] != "-"
        verdict = "aim met" if meets_aim else "must met" if goal.get("meets_must") else "missed"
        rows.append([goal["what"], goal["must"], goal["aim"], goal["reached"], verdict])
    return table(["", "must", "aim", "reached", ""], rows)


def page_time(runs, _old):
    wall_s = runs.paper_json()["timing"]["all_s"]
    return (f"The whole page (must: 300 s on two cores, aim: 60 s) took {wall_s:.0f} s when these "
            "figures were measured.")


def summary(runs, old):
    """The paper's statements and the three methods: docs/results.md."""
    found = Circuits(runs)
    halls, every = runs.paper_json()["section_5_1"]["all_hallways"], classes(runs)[-1]
    icp = halls["mrpt_icp"]
    column = "MRPT ICP, Levenberg-Marquardt"

    def peer(label, cell):
        return kept_cell(old, label, column) if isinstance(icp, str) else cell(icp)

    def norm(chain, digits):
        return norms(found, chain, digits).replace(" m, ", " / ")

    right = "hallway, 20 seeds x 105 pairs, overlap >= 45 %: right"
    error = "mean error of the right ones"
    rows = [
        [right, "all (ICP: not all)", peer(right, lambda each: percent(each[HIGH])),
         percent(halls["paper"][HIGH]), percent(halls["default"][HIGH])],
        [error, "0.04 m, 0.33 deg (ICP: 0.07 m, 0.51 deg)",
         peer(error, lambda each: metres(each["all_pairs"])), metres(halls["paper"]["all_pairs"]),
         metres(halls["default"]["all_pairs"])],
        ["200 buildings of five kinds, overlap >= 45 %: right", "-", "-",
         percent(every["paper"][HIGH]), percent(every["default"][HIGH])],
        [f"answered `matched`, and wrong: of all {every['num_pairs']} pairs within 5 m", "-", "-",
         wrong_of(every["paper"]["all_pairs"]), wrong_of(every["default"]["all_pairs"])],
        ["1.1 km scan to scan, no loop closed: position error after 398 / 901 m", "0.85 / 1.30 m",
         "-", norm("paper", 1), norm("default", 2)]]
    return table(["", "stated by the paper", column, "Setsquare, `--preset paper`", "Setsquare"], rows)


FIGURES = {
    "paper-hallways": hallways,
    "paper-hallways-found": hallways_found,
    "paper-buildings-found": buildings_found,
    "paper-difficulty": difficulty,
    "paper-buildings": buildings,
    "paper-buildings-preset": buildings_preset,
    "paper-by-overlap": by_overlap,
    "paper-factors": factors,
    "paper-circuits": circuits,
    "paper-full-mapper": full_mapper,
    "paper-honesty": honesty,
    "paper-conclusion": conclusion,
    "paper-goals": goals,
    "paper-time": page_time,
    "paper-summary": summary,
}
