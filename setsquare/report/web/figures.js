// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The run in one sentence, its tables and the words of the page.

/** Of what is placed in the map. */
function pathLength({ x, y, condition, begins }) {
  let metres = 0;
  for (let k = 1; k < x.length; ++k) {
    if (condition[k] === kNotPlaced || condition[k - 1] === kNotPlaced || begins.has(k)) continue;
    metres += Math.hypot(x[k] - x[k - 1], y[k] - y[k - 1]);
  }
  return metres;
}

/** What the map leaves out, a sentence; empty where it leaves nothing out. */
function leftOutText(poses) {
  return numNotPlaced(poses) === 0 ? "" :
    " " + counted(numNotPlaced(poses), "scan", "scans") + " could not be placed in the map, which leaves them out.";
}

function summaryText({ poses, closures }, times) {
  if (poses.t.length === 0) return "No scan was mapped.";
  const sums = closures.sums;
  const numAccepted = closures.count - sums.refused;
  const apart = [];
  if (sums["one-axis"]) apart.push(whole(sums["one-axis"]) + " along one axis only");
  if (sums.outvoted) apart.push(whole(sums.outvoted) + " outvoted");
  const found = closures.count === 0 ? "No loop was closed."
    : counted(numAccepted, "loop closure", "loop closures") + " accepted" + (apart.length ? " (" + apart.join(", ") + ")" : "") +
      ", " + whole(sums.refused) + " refused.";
  const troubles = [];
  for (const code of [1, 3]) {
    const { metres, count } = lengthIn(poses, code);
    if (count > 0) troubles.push(kConditions[code] + " along " + inMetres(metres, 1));
  }
  return counted(poses.t.length, "scan", "scans") + " in " + duration(times[1] - times[0]) + ", " +
    inMetres(pathLength(poses), 0) + " travelled. " + found + " " +
    (troubles.length ? "The track is " + troubles.join(" and ") + "." : "The track was never lost.") +
    leftOutText(poses);
}

function makeFigures(figures) {
  const groups = new Map();
  for (const figure of figures) {
    if (!groups.has(figure.group)) groups.set(figure.group, []);
    groups.get(figure.group).push(figure);
  }
  document.getElementById("figures-section").hidden = groups.size === 0;
  for (const [group, rows] of groups) {
    const table = element("table", "", element("caption", "", group));
    for (const { name, value, unit, explanation } of rows) {
      const head = element("th", "", explanation ? term(name, explanation) : name);
      head.scope = "row";
      table.append(element("tr", "", head, element("td", "", value, unit ? element("span", "unit", " " + unit) : "")));
    }
    document.getElementById("figures").append(element("div", "card", table));
  }
}

function makeWords() {
  const list = document.getElementById("words");
  for (const [word, meaning] of Object.entries(kWords)) {
    list.append(element("div", "", element("dt", "", word), element("dd", "", meaning)));
  }
}
