// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Pairs of scans in many buildings.

function classTable(caption, classes, method) {
  return table({
    caption,
    head: ["class", "pairs", "determined, overlap >= 45 %", "of those right", "right at 30-45 %",
      "matched (all pairs)", "wrong", "of matched", "error [m]", "error [deg]", "mean NEES (right matched)",
      "NEES < 7.81 (right matched)", "NEES < 7.81 (all matched)"],
    rows: classes.map((one) => {
      const { all_pairs: all, determined, determined_overlap_45_and_more: high,
        determined_overlap_30_to_45: middle } = one[method];
      return [one.class, all.num_pairs, high.num_pairs, percent(high.success_share), percent(middle.success_share),
        percent(all.matched_share, 1), fault(all.num_wrong), percent(all.wrong_share_of_matched, 3),
        number(determined.success_error_m?.mean, 4), number(determined.success_error_deg?.mean, 3),
        number(all.nees_of_right?.mean, 2), percent(all.nees_of_right_below_7_81_share, 1),
        percent(all.nees_below_7_81_share, 1)];
    }) });
}

/** One value per tenth of overlap that has at least 10 pairs. */
function overlapSeries(name, bins, valueOf) {
  return { name, points: bins.map(({ overlap_from: from, tally }) => (
    [100 * from + 5, tally.num_pairs >= 10 ? valueOf(tally) : NaN])) };
}

function overlapCharts({ default: ours, paper }) {
  const right = (tally) => 100 * tally.success_share;
  const matched = (tally) => 100 * tally.matched_share;
  const wrong = (tally) => (tally.num_matched >= 10 ? 100 * tally.wrong_share_of_matched : NaN);
  const error = (tally) => (tally.success_error_m ? 1000 * tally.success_error_m.mean : NaN);
  const wrongs = [overlapSeries("default", ours.all_by_overlap, wrong),
    overlapSeries("paper", paper.all_by_overlap, wrong)];
  const errors = [overlapSeries("default", ours.determined_by_overlap, error),
    overlapSeries("paper", paper.determined_by_overlap, error)];
  const against = { xLabel: "overlap [%]", x: [0, 100] };
  return charts(
    chart({ ...against, title: "Determined pairs", yLabel: "[%]", y: [0, 100], series: [
      overlapSeries("default, pose right", ours.determined_by_overlap, right),
      overlapSeries("default, matched", ours.determined_by_overlap, matched),
      overlapSeries("paper, pose right", paper.determined_by_overlap, right)] }),
    chart({ ...against, title: "Wrong among matched, all pairs", yLabel: "[%]", y: [0, highest(wrongs, 1)],
      series: wrongs }),
    chart({ ...against, title: "Mean error of the right poses", yLabel: "[mm]", y: [0, highest(errors, 10)],
      series: errors }));
}

function pairListing(title, pairs) {
  const most = 500;
  const all = pairs.length > most ? ` (the first ${most} here, all in paper.json)` : "";
  return folding(`${title}: ${pairs.length}${all}`, table({
    head: ["class", "seed", "reference", "current", "overlap", "status", "error [m]", "[deg]"],
    rows: pairs.slice(0, most).map(({ class: name, seed, reference, current, overlap, answer }) => [
      name, seed, reference, current, percent(overlap, 1), answer.status, number(answer.error_m, 3),
      number(answer.error_deg, 2)]) }));
}

function buildingSection({ buildings }) {
  const classes = buildings.by_class;
  const all = classes[classes.length - 1];
  const { num_overlap_45_and_more: high, num_of_those_undetermined: excluded } = all;
  return [
    paragraph(`${all.num_buildings} buildings of five classes, seeds 1 to ${all.num_buildings / (classes.length - 1)} of `
      + "each; in each one run of about 16 scans of a UTM-30LX, and every pair of them within 5 m: "
      + `${all.num_pairs} pairs, ${percent(all.share_below_60_overlap, 1)} of them below 60 % overlap; `
      + `${percent(all.clutter_share.mean, 1)} of the returns come from furniture, clutter and people. A pose is right `
      + "within 0.2 m and 30 deg of the truth (the paper's limits); an answer 'matched' is wrong when it is off by more "
      + "than 0.2 m or 3 deg."),
    paragraph("Success is counted over the pairs that the floor plan determines. Of the "
      + `${high} pairs of at least 45 % overlap ${excluded} (${percent(excluded / high)}) are not determined: bare `
      + "corridors and round walls, where no matcher can know. They are listed below; wrong answers are counted over all "
      + "pairs, these included."),
    commandLine("setsquare experiment paper --only buildings -o out"),
    classTable("The default matcher", classes, "default"),
    classTable("The paper's method ('matched' above its threshold; it gives no covariance)", classes, "paper"),
    figure(overlapCharts(all), "Against overlap, all classes; tenths of overlap with at least 10 pairs (10 matched pairs "
      + "for the second chart)."),
    pairListing("Wrong answers of the default matcher", buildings.wrong_matched),
    pairListing("Determined pairs of at least 45 % overlap that it misses", buildings.failures_overlap_45_and_more),
    pairListing("Pairs of at least 45 % overlap that the plan does not determine", buildings.excluded_as_undetermined)];
}
