// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Puts the page together: of the sections those that were run.

const kSections = [
  ["section_5_1", "Section 5.1: pairs of scans in a hallway", hallwaySection],
  ["buildings", "Pairs of scans in many buildings", buildingSection],
  ["factors", "One factor at a time", factorSection],
  ["section_5_2", "Section 5.2: a large building, scan to scan", circuitSection],
  ["honesty", "Where the scans do not tell", honestySection]];

function main() {
  const paper = JSON.parse(document.getElementById("numbers").textContent);
  const drawings = JSON.parse(document.getElementById("drawings").textContent);
  const shown = kSections.filter(([name]) => paper[name] !== undefined);
  const content = document.getElementById("content");
  content.append(...statements(paper), commandLine("setsquare experiment paper -o out"));
  content.append(element("nav", { "aria-label": "Contents" }, element("ul", {},
    ...shown.map(([name, title]) => element("li", {}, element("a", { href: `#${name}` }, title))))));
  for (const [name, title, make] of shown) {
    const section = element("section", { id: name }, element("h2", {}, title));
    content.append(section);
    section.append(...make(paper, drawings));
  }
  // For the console and for tests: what is shown.
  window.setsquare = { paper, drawings };
}

main();
