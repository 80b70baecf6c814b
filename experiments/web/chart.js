// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Charts of one or more curves.

/** Round numbers from low to high, about `count` of them. */
function niceTicks(low, high, count) {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((one) => one >= rough * 0.999);
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) ticks.push(k * step);
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return ticks.map((value) => ({ value, words: value.toFixed(decimals) }));
}

class ChartFrame {
  constructor({ x, y }) {
    this.width = widthFor(500);
    this.height = Math.round(Math.max(220, 0.56 * this.width));
    this.left = 52;
    this.right = this.width - 12;
    this.top = 8;
    this.bottom = this.height - 46;
    this.xRange = x;
    this.yRange = y;
  }

  x(value) {
    const [low, high] = this.xRange;
    return this.left + ((this.right - this.left) * (value - low)) / (high - low);
  }

  y(value) {
    const [low, high] = this.yRange;
    const within = Math.min(Math.max(value, low), high);
    return this.bottom - ((this.bottom - this.top) * (within - low)) / (high - low);
  }
}

function drawAxes(svg, frame, { xLabel, yLabel, categories }) {
  for (const { value, words } of niceTicks(...frame.yRange, 5)) {
    const y = frame.y(value);
    svg.append(shape("path", { class: "guide", d: `M${frame.left} ${y}H${frame.right}` }));
    svg.append(shape("text", { class: "faint", x: frame.left - 6, y: y + 4, "text-anchor": "end" }, words));
  }
  const marks = categories
    ? categories.map((words, value) => ({ value, words }))
    : niceTicks(...frame.xRange, frame.width < 400 ? 5 : 8);
  for (const { value, words } of marks) {
    svg.append(shape("text", { class: "faint", x: frame.x(value), y: frame.bottom + 17, "text-anchor": "middle" }, words));
  }
  const middle = 0.5 * (frame.left + frame.right);
  svg.append(shape("text", { x: middle, y: frame.height - 8, "text-anchor": "middle" }, xLabel));
  const place = `translate(12 ${0.5 * (frame.top + frame.bottom)}) rotate(-90)`;
  svg.append(shape("text", { transform: place, "text-anchor": "middle" }, yLabel));
}

/** A curve; a point without a number breaks it. */
function drawCurve(svg, frame, points, style) {
  let path = "";
  let pen = "M";
  const hasDots = points.length <= 40;
  const dots = [];
  for (const [x, y] of points) {
    if (!Number.isFinite(y)) {
      pen = "M";
      continue;
    }
    path += `${pen}${frame.x(x).toFixed(1)} ${frame.y(y).toFixed(1)}`;
    pen = "L";
    if (hasDots) dots.push(shape("circle", { class: `dot ${style}`, cx: frame.x(x), cy: frame.y(y), r: 3 }));
  }
  svg.append(shape("path", { class: `curve ${style}`, d: path }), ...dots);
}

/**
 * A chart with its title and legend. `x` and `y` are [low, high]; `series` are {name, points: [[x, y]]};
 * `categories` name x = 0, 1, ... where the axis has no numbers.
 */
function chart({ title, xLabel, yLabel, x, y, categories, series }) {
  const frame = new ChartFrame({ x, y });
  const svg = shape("svg", { width: frame.width, height: frame.height, role: "img",
    viewBox: `0 0 ${frame.width} ${frame.height}`, "aria-label": title });
  drawAxes(svg, frame, { xLabel, yLabel, categories });
  series.forEach(({ points }, i) => drawCurve(svg, frame, points, `s${1 + (i % 5)}`));
  return element("div", { class: "chart" }, element("h4", {}, title), legend(series.map(({ name }) => name)), svg);
}

function charts(...made) {
  return element("div", { class: "charts" }, ...made);
}
