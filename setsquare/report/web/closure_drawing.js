// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Closures on the map: a line between the two visits and a mark in its middle, one shape per kind.

/** Adds the mark of a kind to a path; `direction`: of a bar, in rad on the page. */
function addMark(path, kind, column, row, radius, direction = 0) {
  if (kind === "refused") {
    path.moveTo(column - radius, row - radius);
    path.lineTo(column + radius, row + radius);
    path.moveTo(column - radius, row + radius);
    path.lineTo(column + radius, row - radius);
  } else if (kind === "one-axis") {
    // A line along the axis that is bound, with an end across at either side.
    const c = 1.5 * radius * Math.cos(direction);
    const s = -1.5 * radius * Math.sin(direction);
    path.moveTo(column - c, row - s);
    path.lineTo(column + c, row + s);
    for (const side of [-1, 1]) {
      path.moveTo(column + side * c + 0.5 * s, row + side * s - 0.5 * c);
      path.lineTo(column + side * c - 0.5 * s, row + side * s + 0.5 * c);
    }
  } else {
    path.moveTo(column + radius, row);
    path.arc(column, row, radius, 0, 2 * Math.PI);
  }
}

/** Draws a path of marks: filled discs, else lines, on a casing that separates them from the map. */
function paintMarks(context, path, kind, radius) {
  const width = Math.max(1.2, 0.42 * radius);
  context.lineCap = "round";
  context.strokeStyle = themeColor("casing");
  context.lineWidth = kind === "accepted" ? Math.min(1.5, 0.4 * radius) : width + 2;
  context.stroke(path);
  context.strokeStyle = context.fillStyle = themeColor(kind);
  if (kind === "accepted") {
    context.fill(path);
  } else {
    context.lineWidth = width;
    context.stroke(path);
  }
}

const kSwatchShapes = {
  accepted: '<circle cx="10" cy="8" r="4.5" fill="C"/>',
  outvoted: '<circle cx="10" cy="8" r="4.2" fill="none" stroke="C" stroke-width="2"/>',
  "one-axis": '<path d="M3.5 8h13M3.5 5v6M16.5 5v6" fill="none" stroke="C" stroke-width="2" stroke-linecap="round"/>',
  refused: '<path d="M6.5 4.5l7 7M6.5 11.5l7-7" stroke="C" stroke-width="2" stroke-linecap="round"/>',
};

/** A mark alone, as legend and list show it. */
function swatchOfKind(kind) {
  const swatch = element("span", "swatch");
  swatch.innerHTML = '<svg viewBox="0 0 20 16" width="20" height="16" aria-hidden="true">' +
    kSwatchShapes[kind].replaceAll("C", "var(--" + kind + ")") + "</svg>";
  return swatch;
}

class ClosureDrawing {
  constructor(closures, scans, gridHeading) {
    this.closures = closures;
    this.scans = scans;
    this.gridHeading = gridHeading;
    const middle = (values) => Float64Array.from(closures.i, (i, k) => 0.5 * (values[i] + values[closures.j[k]]));
    this.u = middle(scans.u);
    this.v = middle(scans.v);
    this.length = closures.i.map((i, k) => Math.hypot(scans.u[i] - scans.u[closures.j[k]], scans.v[i] - scans.v[closures.j[k]]));
  }

  radius(view) {
    return Math.min(5.5, Math.max(1.6, 0.09 * view.scale));
  }

  direction(k) {
    return (this.closures.axes[k] === "y" ? 0.5 * Math.PI : 0) - this.gridHeading;
  }

  draw(context, view) {
    const radius = this.radius(view);
    for (const kind of [...kKinds].reverse()) {
      if (!shared.kinds[kind]) continue;
      const { lines, marks } = this.paths(view, kind, radius);
      context.globalAlpha = 0.5;
      context.strokeStyle = themeColor(kind);
      context.lineWidth = 1;
      context.setLineDash(kind === "refused" ? [4, 3] : []);
      context.stroke(lines);
      context.setLineDash([]);
      context.globalAlpha = 1;
      paintMarks(context, marks, kind, radius);
    }
    if (shared.selected >= 0) this.drawSelected(context, view, shared.selected);
  }

  /** Lines and marks of a kind; those out of sight, or hidden by marks in their place, left out. */
  paths(view, kind, radius) {
    const lines = new Path2D();
    const marks = new Path2D();
    const { width, height } = view;
    const spacing = Math.max(1, 0.6 * radius);
    const taken = new Set();
    for (let k = 0; k < this.closures.count; ++k) {
      if (this.closures.kind[k] !== kind) continue;
      const column = view.column(this.u[k]);
      const row = view.row(this.v[k]);
      const length = this.length[k] * view.scale;
      const reach = 0.5 * length + 12;
      if (column < -reach || row < -reach || column > width + reach || row > height + reach) continue;
      if (length > 2.5 * radius) this.addLine(lines, view, k);
      const spot = Math.round(column / spacing) * 65536 + Math.round(row / spacing);
      if (taken.has(spot)) continue;
      taken.add(spot);
      addMark(marks, kind, column, row, radius, this.direction(k));
    }
    return { lines, marks };
  }

  addLine(path, view, k) {
    for (const [name, scan] of [["moveTo", this.closures.i[k]], ["lineTo", this.closures.j[k]]]) {
      path[name](view.column(this.scans.u[scan]), view.row(this.scans.v[scan]));
    }
  }

  drawSelected(context, view, k) {
    const line = new Path2D();
    this.addLine(line, view, k);
    for (const [color, width] of [["casing", 5], [this.closures.kind[k], 2.5]]) {
      context.strokeStyle = themeColor(color);
      context.lineWidth = width;
      context.stroke(line);
    }
    for (const [name, scan] of [["reference", this.closures.i[k]], ["current", this.closures.j[k]]]) {
      const column = view.column(this.scans.u[scan]);
      const row = view.row(this.scans.v[scan]);
      for (const [color, radius] of [["casing", 6], [name, 4.5]]) {
        context.fillStyle = themeColor(color);
        context.beginPath();
        context.arc(column, row, radius, 0, 2 * Math.PI);
        context.fill();
      }
    }
    const radius = Math.max(5, this.radius(view));
    const mark = new Path2D();
    addMark(mark, this.closures.kind[k], view.column(this.u[k]), view.row(this.v[k]), radius, this.direction(k));
    paintMarks(context, mark, this.closures.kind[k], radius);
    context.strokeStyle = themeColor("pointed");
    context.lineWidth = 2;
    context.beginPath();
    context.arc(view.column(this.u[k]), view.row(this.v[k]), 2 * radius + 3, 0, 2 * Math.PI);
    context.stroke();
  }

  /** The shown closure whose mark is nearest to a pixel and no farther than `reach`, or -1. */
  nearest(view, [column, row], reach) {
    let best = -1;
    let squared = reach * reach;
    for (let k = 0; k < this.closures.count; ++k) {
      if (!shared.kinds[this.closures.kind[k]]) continue;
      const a = view.column(this.u[k]) - column;
      const b = view.row(this.v[k]) - row;
      if (a * a + b * b >= squared) continue;
      squared = a * a + b * b;
      best = k;
    }
    return best;
  }
}
