// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Where the scans do not determine the pose.

/** Mean absolute error and median claimed deviation along one direction. */
function claimWords({ error_m: error, median_claimed_sigma_m: sigma }) {
  if (!error) return "-";
  return `${number(error.mean, 3)} / ${sigma === null ? "unbounded" : number(sigma, 3)}`;
}

function honestySection({ honesty }) {
  const statuses = ["matched", "ambiguous", "degenerate", "no_overlap", "too_few_points"];
  return [
    paragraph(`Places in which the scans do not determine everything, ${honesty.num_seeds} seeds of each: what the default `
      + "matcher answers beside what can be known. Direction: of the answers 'degenerate', mean and highest angle to the "
      + "direction that the floor plan leaves open. Error / claim: of the answers 'matched' and 'degenerate', mean absolute "
      + "error and median claimed standard deviation, along the direction that the plan determines least and across it; "
      + "'unbounded' where the information claims nothing."),
    commandLine("setsquare experiment paper --only honesty -o out"),
    table({
      head: ["place", "what can be known", "pairs", ...statuses.map((status) => status.replaceAll("_", " ")),
        "wrong matched", "direction [deg]", "along: error / claim [m]", "across: error / claim [m]"],
      style: "words",
      rows: honesty.worlds.map((world) => {
        const direction = world.degenerate_direction_error_deg;
        return [world.world, { text: world.what_can_be_known, style: "faint" }, world.num_pairs,
          ...statuses.map((status) => world.statuses[status]), fault(world.num_wrong_matched),
          direction ? `${number(direction.mean, 2)}, ${number(direction.max, 2)}` : "-",
          claimWords(world.along_the_worst_direction), claimWords(world.across_it)];
      }) })];
}
