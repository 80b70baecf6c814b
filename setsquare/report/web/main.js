// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Puts the page together.

function select(closure) {
  shared.selected = closure;
  shared.changed("selected");
}

/** Calls `chosen` with the value of the radio button that is switched on. */
function onChoice(id, chosen) {
  document.getElementById(id).addEventListener("change", (event) => chosen(event.target.value));
}

/** The closure to begin with: of high weight, its two visits as far apart in time as possible. */
function mostTelling({ closures }) {
  let best = -1;
  for (let k = 0; k < closures.count; ++k) {
    if (closures.kind[k] !== "accepted") continue;
    if (best < 0 || closures.apart[k] > closures.apart[best]) best = k;
  }
  return best;
}

function main() {
  const report = unpackReport(JSON.parse(document.getElementById("report").textContent));
  judgeClosures(report.closures, report.scans);
  document.title = report.title;
  document.getElementById("headline").textContent = report.title;

  const map = new MapPanel(report, select);
  const overlay = new OverlayPanel(report);
  const list = new ClosureList(report, select);
  const headings = new HeadingPanel(report);
  document.getElementById("summary").textContent = summaryText(report, map.track.times);
  new MapLegend(report, map.track);
  makeHeadingLegend(report.headings);
  makeFigures(report.figures);
  makeWords();

  const confidence = document.querySelector("input[value=confidence]");
  confidence.disabled = !map.track.hasConfidence;
  if (confidence.disabled) confidence.parentElement.title = "This run has no position uncertainty.";
  onChoice("color-choice", (value) => {
    shared.colorBy = value;
    shared.changed("color");
  });
  onChoice("placing-choice", (value) => {
    shared.placing = value;
    shared.changed("placing");
  });
  onChoice("curve-choice", (value) => headings.show(value));
  document.getElementById("map").addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "n") list.step(1);
    if (event.key === "p") list.step(-1);
  });
  // For the console and for tests: what is shown, and where.
  window.setsquare = { report, shared, map, overlay, list, headings };
  const first = mostTelling(report);
  if (first >= 0) {
    shared.selected = first;
    overlay.hear("selected");
    list.hear("selected");
    headings.ask();
  }
}

main();
