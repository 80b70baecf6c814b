// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The plot of headings over time.

const kNumFrameColors = 4;
const frameColor = (frame) => "frame-" + (frame % kNumFrameColors);

class HeadingPanel {
  constructor(report) {
    this.report = report;
    this.headings = report.headings;
    this.curves = headingCurves(report.headings);
    this.bands = stretches(report.poses, [1, 3]);
    this.curve = "heading";
    this.pointed = -1;
    this.canvas = document.getElementById("headings");
    this.tip = document.getElementById("heading-tip");
    this.ask = drawOnDemand(this.canvas, () => this.draw());
    const times = this.headings.t;
    document.getElementById("heading-empty").hidden = times.length > 0;
    const ends = times.length ? [times.reduce((a, b) => Math.min(a, b)), times.reduce((a, b) => Math.max(a, b))] : [0, 1];
    this.view = new TimeView(this.canvas, ends, {
      onChange: this.ask,
      onPoint: (pixel) => this.point(pixel),
      onClick: (pixel) => {
        this.point(pixel);
        shared.changed("pinned");
      },
      controls: document.getElementById("heading-section"),
    });
    shared.listeners.push((what) => what !== "pointed" && this.ask());
  }

  show(curve) {
    this.curve = curve;
    this.ask();
  }

  row(value) {
    const [low, high] = this.curves[this.curve].range;
    const height = this.view.height - kPlotMargin.top - kPlotMargin.bottom;
    return kPlotMargin.top + (height * (high - value)) / (high - low);
  }

  draw() {
    const context = sharpContext(this.canvas);
    if (this.headings.t.length === 0) return;
    const curve = this.curves[this.curve];
    context.font = "12px " + getComputedStyle(document.body).fontFamily;
    this.drawAxes(context, curve);
    context.save();
    context.beginPath();
    context.rect(kPlotMargin.left, kPlotMargin.top, this.view.length(),
                 this.view.height - kPlotMargin.top - kPlotMargin.bottom);
    context.clip();
    this.drawBands(context);
    if (curve.tracked) this.drawLine(context, curve, curve.tracked, "tracked", this.curve === "drift" ? 1.8 : 1, [5, 3]);
    if (curve.points) this.drawPoints(context, curve.points);
    this.drawLine(context, curve, curve.fused, "fused", 1.3, []);
    this.drawSelected(context);
    if (this.pointed >= 0) this.drawUpright(context, this.headings.t[this.pointed], "pointed", [2, 3]);
    context.restore();
  }

  drawAxes(context, curve) {
    const bottom = this.view.height - kPlotMargin.bottom;
    const right = kPlotMargin.left + this.view.length();
    context.strokeStyle = themeColor("line");
    context.fillStyle = themeColor("faint");
    context.lineWidth = 1;
    const [low, high] = curve.range;
    const step = curve.ticks || niceBelow((high - low) / 4);
    context.textAlign = "right";
    context.textBaseline = "middle";
    const lines = new Path2D();
    for (let tick = Math.ceil(low / step) * step; tick <= high; tick += step) {
      const row = Math.round(this.row(tick)) + 0.5;
      lines.moveTo(kPlotMargin.left, row);
      lines.lineTo(right, row);
      context.fillText(fixed(tick, step < 1 ? 1 : 0) + kDegree, kPlotMargin.left - 8, row);
    }
    const seconds = this.view.length() / this.view.scale;
    const spacing = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 14400, 36000, 86400]
      .find((size) => size * this.view.scale >= 90) || seconds;
    context.textAlign = "center";
    context.textBaseline = "top";
    for (let tick = Math.ceil(this.view.from / spacing) * spacing; tick <= this.view.from + seconds; tick += spacing) {
      const column = Math.round(this.view.column(tick)) + 0.5;
      lines.moveTo(column, kPlotMargin.top);
      lines.lineTo(column, bottom);
      context.fillText(clock(tick, spacing < 1 ? 1 : 0), column, bottom + 7);
    }
    context.stroke(lines);
    context.textAlign = "left";
    context.fillText("min:s", 8, bottom + 7);
  }

  drawBands(context) {
    context.globalAlpha = 0.28;
    for (const { from, to, code } of this.bands) {
      context.fillStyle = themeColor(code === 1 ? "degenerate" : "lost");
      const left = this.view.column(from);
      context.fillRect(left, 0, Math.max(this.view.column(to) - left, 1.5), this.view.height);
    }
    context.globalAlpha = 1;
  }

  drawLine(context, curve, values, color, width, dash) {
    const path = new Path2D();
    values.forEach((value, k) => {
      const column = this.view.column(this.headings.t[k]);
      const isJump = k === 0 || (curve.isCyclic && Math.abs(value - values[k - 1]) > 180);
      path[isJump ? "moveTo" : "lineTo"](column, this.row(value));
    });
    context.strokeStyle = themeColor(color);
    context.lineWidth = width;
    context.setLineDash(dash);
    context.stroke(path);
    context.setLineDash([]);
  }

  /** The greater the weight of a measurement, the stronger its point. */
  drawPoints(context, points) {
    const size = this.view.scale / this.view.fittedScale > 6 ? 5 : 3;
    const buckets = new Map();
    points.forEach((value, k) => {
      if (value === null) return;
      const strength = Math.round(4 * Math.min(1, Math.max(0, this.headings.weight[k])));
      const key = strength + " " + frameColor(this.headings.frame[k]);
      if (!buckets.has(key)) buckets.set(key, new Path2D());
      buckets.get(key).rect(this.view.column(this.headings.t[k]) - 0.5 * size, this.row(value) - 0.5 * size, size, size);
    });
    for (const [key, path] of [...buckets].sort()) {
      const [strength, color] = key.split(" ");
      context.globalAlpha = 0.22 + 0.195 * Number(strength);
      context.fillStyle = themeColor(color);
      context.fill(path);
    }
    context.globalAlpha = 1;
  }

  drawUpright(context, time, color, dash) {
    context.strokeStyle = themeColor(color);
    context.lineWidth = 1.5;
    context.setLineDash(dash);
    context.beginPath();
    context.moveTo(this.view.column(time), 0);
    context.lineTo(this.view.column(time), this.view.height);
    context.stroke();
    context.setLineDash([]);
  }

  drawSelected(context) {
    if (shared.selected < 0) return;
    const { closures, scans } = this.report;
    this.drawUpright(context, scans.t[closures.i[shared.selected]], "reference", []);
    this.drawUpright(context, scans.t[closures.j[shared.selected]], "current", []);
  }

  point(pixel) {
    let best = -1;
    if (pixel && pixel[0] >= kPlotMargin.left) {
      const time = this.view.time(pixel[0]);
      this.headings.t.forEach((t, k) => {
        if (best < 0 || Math.abs(t - time) < Math.abs(this.headings.t[best] - time)) best = k;
      });
    }
    this.pointed = best;
    shared.pointedTime = best < 0 ? NaN : this.headings.t[best];
    showTip(this.tip, best < 0 ? "" : this.text(best), pixel || undefined);
    this.ask();
    shared.changed("pointed");
  }

  text(k) {
    const { t, measured, fused, tracked, frame, weight } = this.headings;
    const near = fused[k] + wrappedToQuarter(measured[k] - fused[k]);
    return "at " + clock(t[k]) + "\nfused " + inDegrees(wrapped(fused[k]), 2) +
      (frame[k] < 0 ? "\nnot measured" : "\nmeasured " + inDegrees(wrapped(near), 2) + " (weight " + fixed(weight[k], 2) +
       (this.headings.frames.length > 1 ? ", frame " + (frame[k] + 1) : "") + ")") +
      "\ntracked " + inDegrees(wrapped(tracked[k]), 2);
  }
}
