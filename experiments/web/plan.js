// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A floor plan and ways through it, to scale.

function boxOf({ walls, paths }) {
  const box = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
  const extend = (x, y) => {
    box.left = Math.min(box.left, x);
    box.right = Math.max(box.right, x);
    box.low = Math.min(box.low, y);
    box.high = Math.max(box.high, y);
  };
  for (const [x1, y1, x2, y2] of walls) {
    extend(x1, y1);
    extend(x2, y2);
  }
  for (const { points } of paths) for (const [x, y] of points) extend(x, y);
  return box;
}

/** From metres of the map to pixels, y up. */
class PlanScale {
  constructor(drawing, tallest) {
    const margin = 12;
    const box = boxOf(drawing);
    const width = Math.max(box.right - box.left, 1);
    const height = Math.max(box.high - box.low, 1);
    this.box = box;
    this.pixels = Math.min((widthFor(1070) - 2 * margin) / width, tallest / height);
    this.margin = margin;
    this.width = Math.ceil(width * this.pixels + 2 * margin);
    this.height = Math.ceil(height * this.pixels + 2 * margin);
  }

  at(x, y) {
    return [this.margin + this.pixels * (x - this.box.left), this.margin + this.pixels * (this.box.high - y)];
  }

  words(x, y) {
    return this.at(x, y).map((value) => value.toFixed(1)).join(" ");
  }
}

/** `drawing` is {walls, paths}; with `hasNumbers` every pose is a dot with its number. */
function plan(drawing, hasNumbers = false) {
  const scale = new PlanScale(drawing, hasNumbers ? 520 : 800);
  const svg = shape("svg", { width: scale.width, height: scale.height, role: "img",
    viewBox: `0 0 ${scale.width} ${scale.height}`, "aria-label": "floor plan" });
  const walls = drawing.walls.map(([x1, y1, x2, y2]) => `M${scale.words(x1, y1)}L${scale.words(x2, y2)}`);
  svg.append(shape("path", { class: "wall", d: walls.join("") }));
  // The last way lies below: a chart next to the plan gives the first ones the same colours.
  [...drawing.paths.entries()].reverse().forEach(([i, { points }]) => {
    const style = `s${1 + (i % 5)}`;
    const line = points.map(([x, y]) => scale.words(x, y)).join("L");
    svg.append(shape("path", { class: `curve ${style}`, d: `M${line}` }));
    if (!hasNumbers) return;
    points.forEach(([x, y], k) => {
      const [column, row] = scale.at(x, y);
      svg.append(shape("circle", { class: `dot ${style}`, cx: column, cy: row, r: 3 }));
      svg.append(shape("text", { x: column + 4, y: row - 5 }, String(k)));
    });
  });
  const box = element("div", {});
  box.append(legend(drawing.paths.map(({ name }) => name)), svg);
  return box;
}
