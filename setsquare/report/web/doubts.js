// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Where the map may be wrong: numbered marks on the map, and the list that says why.

class Doubts {
  /** `doubts`: number, kind, reason, t and u, v in m on the page. */
  constructor({ verdict, doubts }, show) {
    this.doubts = doubts;
    const line = document.getElementById("verdict");
    line.hidden = !verdict;
    line.textContent = verdict ? "Map: " + verdict : "";
    line.classList.toggle("doubtful", doubts.length > 0);
    const list = document.getElementById("doubts");
    list.hidden = doubts.length === 0;
    for (const doubt of doubts) list.append(this.makeItem(doubt, show));
  }

  makeItem(doubt, show) {
    const button = element("button", "", "Show");
    button.type = "button";
    button.setAttribute("aria-label", "Show doubt " + doubt.number + " on the map");
    button.addEventListener("click", () => show(doubt));
    return element("li", "", element("b", "", doubt.kind), ": " + doubt.reason + " ", button);
  }

  draw(context, view) {
    context.font = "700 12px " + getComputedStyle(document.body).fontFamily;
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (const { number, u, v } of this.doubts) {
      const mark = new Path2D();
      mark.arc(view.column(u), view.row(v), 10, 0, 2 * Math.PI);
      context.fillStyle = themeColor("doubt");
      context.strokeStyle = themeColor("casing");
      context.lineWidth = 3;
      context.stroke(mark);
      context.fill(mark);
      context.fillStyle = themeColor("casing");
      context.fillText(String(number), view.column(u), view.row(v) + 0.5);
    }
    context.textBaseline = "alphabetic";
  }

  /** The doubt whose mark is at a pixel, or null. */
  at(view, [column, row]) {
    return this.doubts.find(({ u, v }) => Math.hypot(view.column(u) - column, view.row(v) - row) <= 11) || null;
  }
}
