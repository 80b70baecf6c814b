// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The closures as a list: only the rows in sight are in the page, so that thousands cost nothing.

const kRowHeight = 30;

class ClosureList {
  constructor(report, select) {
    this.report = report;
    this.select = select;
    this.list = document.getElementById("closure-list");
    this.space = this.list.firstElementChild;
    this.order = document.getElementById("list-order");
    this.rows = new Map();  // By closure.
    this.list.addEventListener("scroll", () => this.draw());
    this.list.addEventListener("keydown", (event) => this.key(event));
    this.order.addEventListener("change", () => this.arrange());
    new ResizeObserver(() => this.draw()).observe(this.list);
    shared.listeners.push((what) => this.hear(what));
    this.arrange();
  }

  hear(what) {
    if (what === "kinds") this.arrange();
    if (what === "selected") this.reveal();
  }

  arrange() {
    const { closures, scans } = this.report;
    this.shown = shownClosures(closures, this.order.value, scans);
    this.space.style.height = kRowHeight * this.shown.length + "px";
    document.getElementById("list-count").textContent = closures.count === 0
      ? "This run closed no loop." : whole(this.shown.length) + " of " + counted(closures.count, "closure", "closures");
    for (const row of this.rows.values()) row.remove();
    this.rows.clear();
    this.reveal();
  }

  reveal() {
    const place = this.shown.indexOf(shared.selected);
    if (place >= 0) {
      const top = place * kRowHeight;
      const height = this.list.clientHeight;
      if (top < this.list.scrollTop) this.list.scrollTop = top;
      if (top + kRowHeight > this.list.scrollTop + height) this.list.scrollTop = top + kRowHeight - height;
    }
    this.draw();
  }

  draw() {
    const first = Math.max(0, Math.floor(this.list.scrollTop / kRowHeight) - 4);
    const end = Math.min(this.shown.length, first + Math.ceil(this.list.clientHeight / kRowHeight) + 8);
    const inSight = new Set(this.shown.slice(first, end));
    for (const [closure, row] of this.rows) {
      if (inSight.has(closure)) continue;
      row.remove();
      this.rows.delete(closure);
    }
    for (let place = first; place < end; ++place) {
      const closure = this.shown[place];
      if (!this.rows.has(closure)) this.rows.set(closure, this.makeRow(closure, place));
      this.rows.get(closure).setAttribute("aria-selected", String(closure === shared.selected));
    }
    if (inSight.has(shared.selected)) this.list.setAttribute("aria-activedescendant", "closure-" + shared.selected);
    else this.list.removeAttribute("aria-activedescendant");
  }

  makeRow(k, place) {
    const { closures, scans } = this.report;
    const kind = closures.kind[k];
    const row = element("div", "row",
                        swatchOfKind(kind),
                        element("span", "", clock(scans.t[closures.i[k]], 0)),
                        element("span", "faint", "\u2194"),
                        element("span", "", clock(scans.t[closures.j[k]], 0)),
                        element("span", "faint", closures.reason[k]),
                        element("span", "", closures.axes[k] === "xy" ? "" : closures.axes[k] + " only  ",
                                element("span", "faint", "w "), fixed(closures.weight[k], 2)));
    row.id = "closure-" + k;
    row.setAttribute("role", "option");
    row.setAttribute("aria-posinset", String(place + 1));
    row.setAttribute("aria-setsize", String(this.shown.length));
    row.setAttribute("aria-label", kKindNames[kind] + " closure, " + clock(scans.t[closures.i[k]], 0) + " and " +
                     clock(scans.t[closures.j[k]], 0) + ", weight " + fixed(closures.weight[k], 2));
    row.style.top = place * kRowHeight + "px";
    row.addEventListener("click", () => this.select(k));
    this.space.append(row);
    return row;
  }

  /** Selects the closure that many rows further. */
  step(rows) {
    if (this.shown.length === 0) return;
    const place = this.shown.indexOf(shared.selected);
    const next = place < 0 ? (rows > 0 ? 0 : this.shown.length - 1) : place + rows;
    this.select(this.shown[Math.min(Math.max(next, 0), this.shown.length - 1)]);
  }

  key(event) {
    const page = Math.max(1, Math.floor(this.list.clientHeight / kRowHeight) - 1);
    const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -Infinity, End: Infinity };
    if (!(event.key in steps)) return;
    event.preventDefault();
    this.step(steps[event.key]);
  }
}
