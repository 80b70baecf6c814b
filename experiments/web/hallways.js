// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Section 5.1: pairs of scans in a hallway.

/** A triangle of cells: references down, current scans across, as in the paper's tables. */
function matrix(title, pairs, cellOf) {
  const count = 1 + Math.max(...pairs.map(({ current }) => current));
  const made = element("table", { class: "matrix" });
  const head = element("tr", {}, element("th"));
  for (let current = 1; current < count; ++current) head.append(element("th", {}, String(current)));
  made.append(head);
  for (let reference = 0; reference + 1 < count; ++reference) {
    const row = element("tr", {}, element("th", {}, String(reference)));
    for (let current = 1; current < count; ++current) {
      const pair = pairs.find((one) => one.reference === reference && one.current === current);
      row.append(pair ? cell("td", cellOf(pair)) : element("td"));
    }
    made.append(row);
  }
  return element("div", {}, element("h3", {}, title),
    element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": title }, made));
}

/** The paper's limits: within 0.2 m and 30 deg of the truth. */
function isRight({ error_m: error, error_deg: turn }) {
  return error !== null && error <= 0.2 && turn !== null && turn <= 30;
}

function matrices({ pairs_of_the_first: pairs, first_hallway: first }) {
  const verdict = (method) => (pair) => (isRight(pair[method]) ? "S" : { text: "F", style: "bad" });
  const box = element("div", { class: "matrices" });
  box.append(matrix("Table 1: overlap in %", pairs, ({ overlap }) => (
    { text: number(100 * overlap), style: overlap > 0.4 ? "high" : "faint" })));
  if (typeof first.mrpt_icp === "object") {
    box.append(matrix("Table 2: ICP", pairs, verdict("mrpt_icp")));
  } else {
    box.append(element("div", { id: "no-icp" }, element("h3", {}, "Table 2: ICP"), howToGetMrpt()));
  }
  box.append(matrix("Table 3: the paper's method", pairs, verdict("paper")));
  box.append(matrix("The default matcher", pairs, verdict("default")));
  return box;
}

function hallwayRow(name, method, time) {
  const { all_pairs: all, determined_overlap_45_and_more: high } = method;
  return [name, countOf(all.num_success, all.num_pairs), countOf(high.num_success, high.num_pairs),
    percent(high.success_share, 1), meanAndSigma(all.success_error_m, 4), meanAndSigma(all.success_error_deg, 3), time];
}

function hallwayTable(caption, summary, times) {
  const faint = (text) => ({ text, style: "faint" });
  const time = (value) => (times ? `${number(value, 2)} ms` : "-");
  const icp = typeof summary.mrpt_icp === "object"
    ? hallwayRow("here: MRPT's ICP", summary.mrpt_icp, time(times?.mrpt_icp_median_ms))
    : ["here: MRPT's ICP", faint("left out"), "-", "-", "-", "-", "-"];
  return table({
    caption,
    head: ["method", "right, all pairs", "right, overlap >= 45 %", "share", "error [m] (sigma)",
      "error [deg] (sigma)", "one match"],
    rows: [
      [faint("the paper states: ICP"), "-", "-", "-", "0.07 (0.03)", "0.51 (0.32)", "11 ms, 2014"],
      [faint("the paper states: its method"), "-", "all", "100 %", "0.04 (0.02)", "0.33 (0.25)", "17 ms, 2014"],
      icp,
      hallwayRow("here: the paper's method (--preset paper)", summary.paper, time(times?.paper_median_ms)),
      hallwayRow("here: the default matcher", summary.default, time(times?.default_median_ms))] });
}

function hallwaySection({ section_5_1: hallways, timing }, drawings) {
  const pairs = hallways.pairs_of_the_first;
  const numScans = 1 + Math.max(...pairs.map(({ current }) => current));
  return [
    paragraph(`${numScans} scans of a UTM-30LX, 0.4 m or 10 deg apart, along a hallway; all ${pairs.length} pairs, `
      + "without an initial guess. Right is a pose within 0.2 m and 30 deg of the truth. ICP is MRPT's, "
      + "Levenberg-Marquardt, default parameters, started at zero. Overlap is the share of the current scan's returns "
      + "that, at the true pose, lie within 0.2 m of a surface that the reference saw. The text of the paper gives "
      + "aggregates, not the cells of its tables."),
    commandLine("setsquare experiment paper --only section_5_1 -o out"),
    figure(plan(drawings.hallway, true), "Figure 4: the hallway of seed 1 and the places of its scans."),
    matrices(hallways),
    hallwayTable("The first hallway", hallways.first_hallway, timing.a_match),
    hallwayTable(`The same over ${hallways.num_hallways} seeds of hallways`, hallways.all_hallways, null)];
}
