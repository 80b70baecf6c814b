// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The two scans of the selected closure, one over the other, and what is known of it.

/** Neighbouring returns farther apart than this lie on different surfaces. */
const surfaceGap = (range) => Math.max(0.25, 0.06 * range);

class OverlayPanel {
  constructor(report) {
    this.report = report;
    this.canvas = document.getElementById("overlay");
    this.ask = drawOnDemand(this.canvas, () => this.draw());
    this.placed = [];
    this.view = new PlaneView(this.canvas, [-5, -5, 5, 5], { onChange: this.ask });
    shared.listeners.push((what) => this.hear(what));
    if (report.closures.count === 0) {
      document.getElementById("overlay-empty").textContent = "This run closed no loop: no place was recognised a second time.";
    }
  }

  hear(what) {
    if (what !== "selected" && what !== "placing") return;
    const k = shared.selected;
    document.getElementById("overlay-empty").hidden = k >= 0;
    if (k < 0) return;
    const { closures, scans } = this.report;
    const first = poseOf(scans, closures.i[k]);
    const second = shared.placing === "map" ? poseOf(scans, closures.j[k])
                                            : composed(first, poseOf(closures, k));
    this.placed = [this.place("reference", closures.i[k], first), this.place("current", closures.j[k], second)];
    if (what === "selected") this.view.setBox(this.box());
    this.tell(k);
    this.ask();
  }

  /** A scan at a pose in the map frame: its points on the upright page. */
  place(color, scan, pose) {
    const { scans, gridHeading } = this.report;
    const origin = composed({ x: 0, y: 0, h: -gridHeading }, pose);
    const c = Math.cos(origin.h);
    const s = Math.sin(origin.h);
    const first = scans.first[scan];
    const u = [];
    const v = [];
    const range = [];
    for (let p = first; p < first + scans.points[scan]; ++p) {
      u.push(origin.x + c * scans.px[p] - s * scans.py[p]);
      v.push(origin.y + s * scans.px[p] + c * scans.py[p]);
      range.push(Math.hypot(scans.px[p], scans.py[p]));
    }
    return { color, u, v, range, origin };
  }

  /** Both scans but their outermost points. */
  box() {
    const trimmed = (values) => {
      const sorted = Float64Array.from(values).sort();
      const rank = (share) => sorted[Math.round(share * (sorted.length - 1))];
      return [rank(0.02), rank(0.98)];
    };
    const [left, right] = trimmed(this.placed.flatMap((scan) => [...scan.u, scan.origin.x]));
    const [bottom, top] = trimmed(this.placed.flatMap((scan) => [...scan.v, scan.origin.y]));
    return [left, bottom, right, top];
  }

  draw() {
    const context = sharpContext(this.canvas);
    if (shared.selected < 0) return;
    for (const scan of this.placed) this.drawSeen(context, scan);
    for (const scan of this.placed) this.drawSurfaces(context, scan);
    for (const scan of this.placed) this.drawPoints(context, scan);
    for (const scan of this.placed) this.drawRobot(context, scan);
    drawScaleBar(context, this.canvas, this.view.scale);
  }

  /** What the beams crossed, faintly. */
  drawSeen(context, { color, u, v, origin }) {
    context.fillStyle = themeColor(color);
    context.globalAlpha = 0.07;
    context.beginPath();
    context.moveTo(this.view.column(origin.x), this.view.row(origin.y));
    for (let p = 0; p < u.length; ++p) context.lineTo(this.view.column(u[p]), this.view.row(v[p]));
    context.fill();
    context.globalAlpha = 1;
  }

  drawSurfaces(context, { color, u, v, range }) {
    context.strokeStyle = themeColor(color);
    context.lineJoin = context.lineCap = "round";
    // The first scan's are wide, the second's narrow: both show where they coincide.
    context.lineWidth = color === "reference" ? 7 : 2;
    context.globalAlpha = color === "reference" ? 0.45 : 0.8;
    context.beginPath();
    for (let p = 1; p < u.length; ++p) {
      if (Math.hypot(u[p] - u[p - 1], v[p] - v[p - 1]) > surfaceGap(Math.min(range[p], range[p - 1]))) continue;
      context.moveTo(this.view.column(u[p - 1]), this.view.row(v[p - 1]));
      context.lineTo(this.view.column(u[p]), this.view.row(v[p]));
    }
    context.stroke();
    context.globalAlpha = 1;
  }

  drawPoints(context, { color, u, v }) {
    const radius = Math.min(2.6, Math.max(1.4, 0.02 * this.view.scale)) + (color === "reference" ? 0.9 : 0);
    context.fillStyle = themeColor(color);
    context.beginPath();
    for (let p = 0; p < u.length; ++p) {
      const column = this.view.column(u[p]);
      const row = this.view.row(v[p]);
      context.moveTo(column + radius, row);
      context.arc(column, row, radius, 0, 2 * Math.PI);
    }
    context.fill();
  }

  drawRobot(context, { color, origin }) {
    const column = this.view.column(origin.x);
    const row = this.view.row(origin.y);
    const robot = new Path2D();
    for (const [angle, length] of [[0, 13], [2.5, 9], [Math.PI, 4], [-2.5, 9]]) {
      robot.lineTo(column + length * Math.cos(origin.h + angle), row - length * Math.sin(origin.h + angle));
    }
    robot.closePath();
    context.lineJoin = "round";
    context.lineWidth = 3;
    context.strokeStyle = themeColor("casing");
    context.stroke(robot);
    context.fillStyle = themeColor(color);
    context.fill(robot);
  }

  tell(k) {
    const { closures, scans, start } = this.report;
    const kind = closures.kind[k];
    const i = closures.i[k];
    const j = closures.j[k];
    const axes = closures.axes[k];
    const dot = (color) => {
      const made = element("span", "dot");
      made.style.background = "var(--" + color + ")";
      return made;
    };
    const facts = document.getElementById("closure-facts");
    const verdict = element("div", "verdict", dot(kind), element("span", "", term(kKindNames[kind]),
      axes === "xy" || kind === "one-axis" ? "" : ", one axis only",
      axes === "xy" ? "" : ": binds " + axes + " alone, " + (axes === "x" ? "y" : "x") + " is left open",
      closures.reason[k] ? " \u2013 " + closures.reason[k] : ""));
    const rows = [verdict];
    const add = (key, ...value) => rows.push(element("span", "key", key), element("span", "", ...value));
    const visit = (scan) => clock(scans.t[scan]) + "  (stamp " + stampText(start, scans.t[scan]) + ")";
    add(element("span", "", dot("reference"), " first scan"), visit(i));
    add(element("span", "", dot("current"), " second scan"), visit(j) + ", " + duration(closures.apart[k]) + " apart");
    add("seen from the first", "x " + inMetres(closures.x[k], 3) + ", y " + inMetres(closures.y[k], 3) + ", " + inDegrees(closures.h[k], 2));
    add(term("weight"), fixed(closures.weight[k], 2));
    add(term("residual"), inMetres(closures.residual[k], 3) + (axes === "xy" ? "" : " along " + axes) + ", " +
        inDegrees(closures.turnResidual[k], 2));
    facts.replaceChildren(...rows);
  }
}
