// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The first section of the page: the paper's statements and our results.

const kNothing = { text: "-", style: "faint" };
const kLeftOut = { text: "left out", style: "faint" };

function pairStatements({ section_5_1: hallways, timing }) {
  if (!hallways) return [];
  const { all_hallways: all, stated_by_the_paper: stated, num_hallways: count } = hallways;
  const hasIcp = typeof all.mrpt_icp === "object";
  const row = (what, theirs, theirIcp, value) => [
    what, theirs, value(all.paper), value(all.default), kNothing, theirIcp, hasIcp ? value(all.mrpt_icp) : kLeftOut];
  const right = (method) => {
    const { num_success: part, num_pairs: whole, success_share: share } = method.determined_overlap_45_and_more;
    return `${percent(share, 1)} (${countOf(part, whole)})`;
  };
  const pair = (spread, decimals) => `${number(spread.mean, decimals)} (${number(spread.sigma, decimals)})`;
  const rows = [
    row(`Pairs of scans in a hallway, overlap of 45 % and more: right, ${count} hallways`, "all", kNothing, right),
    row("The same: error of the right ones in m, mean (sigma)", pair(stated.error_m, 2), pair(stated.icp_error_m, 2),
      (method) => meanAndSigma(method.all_pairs.success_error_m, 4)),
    row("The same in deg", pair(stated.error_deg, 2), pair(stated.icp_error_deg, 2),
      (method) => meanAndSigma(method.all_pairs.success_error_deg, 3))];
  const times = timing.a_match;
  if (times) {
    rows.push(["One match in ms, median", `${stated.match_ms} (2014)`, number(times.paper_median_ms, 2),
      number(times.default_median_ms, 2), kNothing, `${stated.icp_match_ms} (2014)`,
      hasIcp ? number(times.mrpt_icp_median_ms, 2) : kLeftOut]);
  }
  return rows;
}

function circuitStatements({ section_5_2: circuits }) {
  if (!circuits) return [];
  const { median_closure_errors: errors, stated_by_the_paper: stated, runs } = circuits;
  const closure = (index, { x_m: x, y_m: y }) => [
    `Large building, closure error in m after ${number(runs[0].circuits[index].length_m)} m`,
    `${Math.hypot(x, y).toFixed(2)}`, number(errors.paper.norm_m[index], 3), number(errors.default.norm_m[index], 3),
    number(errors.full_mapper.norm_m[index], 3), kNothing, kNothing];
  const heading = (method) => number(median(runs.map((run) => run[method].heading.end_deg)), 3);
  return [
    closure(0, stated.after_398_m),
    closure(1, stated.after_901_m),
    [`Large building, heading error in deg after ${number(runs[0].track_m)} m`, "no errors in the direction",
      heading("paper"), heading("default"), heading("full_mapper"), kNothing, kNothing]];
}

function statements(paper) {
  const rows = [...pairStatements(paper), ...circuitStatements(paper)];
  if (rows.length === 0) return [];
  const made = [table({
    caption: "What the paper states, and what came out here (medians of the seeds in the large building; there "
      + "only the full mapper closes loops)",
    style: "statements",
    head: ["", "the paper: its method", "here: the paper's method", "here: the default matcher",
      "here: the full mapper", "the paper: ICP", "here: MRPT's ICP"],
    rows })];
  if (paper.section_5_1 && typeof paper.section_5_1.all_hallways.mrpt_icp !== "object") made.push(howToGetMrpt());
  return made;
}

function howToGetMrpt() {
  return element("p", { class: "notice" }, "MRPT's ICP is left out: install libmrpt-dev (",
    element("code", {}, "tools/install_packages peers"), "), build again.");
}
