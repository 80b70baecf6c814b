// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// One factor at a time.

function levelTable(factor, levels) {
  return table({
    head: [factor, "pairs", "right at >= 45 %", "right at 30-45 %", "matched", "wrong", "of matched", "error [m]",
      "error [deg]", "mean NEES (right)", "NEES < 7.81 (right)", "paper: right at >= 45 %", "paper: wrong of matched"],
    rows: levels.map(({ level, num_pairs: count, default: ours, paper }) => {
      const { all_pairs: all, determined } = ours;
      return [level, count, percent(ours.determined_overlap_45_and_more.success_share),
        percent(ours.determined_overlap_30_to_45.success_share), percent(all.matched_share, 1), fault(all.num_wrong),
        percent(all.wrong_share_of_matched, 3), number(determined.success_error_m?.mean, 4),
        number(determined.success_error_deg?.mean, 3), number(all.nees_of_right?.mean, 2),
        percent(all.nees_of_right_below_7_81_share, 1), percent(paper.determined_overlap_45_and_more.success_share),
        percent(paper.all_pairs.wrong_share_of_matched, 1)];
    }) });
}

/** Success against overlap, one curve per level. */
function levelsAgainstOverlap(levels) {
  return charts(chart({
    title: "Default matcher: right, of determined pairs", xLabel: "overlap [%]", yLabel: "[%]", x: [0, 100], y: [0, 100],
    series: levels.map(({ level, default: ours }) => ({
      name: level,
      points: ours.determined_success_by_tenth_of_overlap.map((share, tenth) => (
        [10 * tenth + 5, ours.num_determined_by_tenth_of_overlap[tenth] >= 10 ? 100 * share : NaN])) })) }));
}

/** Success, wrong answers and errors against the level, for factors of many levels. */
function againstLevels(factor, levels) {
  const series = (name, valueOf) => ({ name, points: levels.map((level, i) => [i, valueOf(level)]) });
  const shown = (value, unit) => (value === null || value === undefined ? NaN : unit * value);
  const of = (method, summary, field, unit) => (level) => shown(level[method][summary][field], unit);
  const error = (method) => (level) => shown(level[method].determined.success_error_m?.mean, 1000);
  const high = "determined_overlap_45_and_more";
  const wrongs = [series("default", of("default", "all_pairs", "wrong_share_of_matched", 100)),
    series("paper", of("paper", "all_pairs", "wrong_share_of_matched", 100))];
  const errors = [series("default", error("default")), series("paper", error("paper"))];
  const against = { xLabel: factor, x: [-0.3, levels.length - 0.7], categories: levels.map(({ level }) => level) };
  return charts(
    chart({ ...against, title: "Right at >= 45 % overlap", yLabel: "[%]", y: [0, 100], series: [
      series("default", of("default", high, "success_share", 100)),
      series("default, matched", of("default", high, "matched_share", 100)),
      series("paper", of("paper", high, "success_share", 100))] }),
    chart({ ...against, title: "Wrong among matched", yLabel: "[%]", y: [0, highest(wrongs, 1)], series: wrongs }),
    chart({ ...against, title: "Mean error of the right poses", yLabel: "[mm]", y: [0, highest(errors, 10)],
      series: errors }));
}

function factorSection({ factors }) {
  const made = [
    paragraph(`The buildings of the first ${factors.num_seeds_of_each_class} seeds of each class again, a fifth of their `
      + "pairs, with one thing changed at a time: the people, the field of view, the number of beams over 270 deg, the "
      + "scanner, the robot's speed (it smears a sweep). Pairs and limits are those of the section before; under fewer "
      + "beams a pair keeps the overlap that all 1081 beams give it."),
    commandLine("setsquare experiment paper --only factors -o out")];
  for (const factor of new Set(factors.levels.map((level) => level.factor))) {
    const levels = factors.levels.filter((level) => level.factor === factor);
    made.push(element("h3", {}, factor), levelTable(factor, levels),
      levels.length > 5 ? againstLevels(factor, levels) : levelsAgainstOverlap(levels));
  }
  return made;
}
