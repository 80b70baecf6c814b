// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The track in the colours of time or confidence, with what went wrong along it.

class TrackDrawing {
  constructor(poses) {
    this.poses = poses;
    this.count = poses.t.length;
    const isPlaced = (code) => code !== kNotPlaced;
    this.firstPlaced = poses.condition.findIndex(isPlaced);
    this.lastPlaced = poses.condition.findLastIndex(isPlaced);
    const times = poses.t;
    this.times = [0, 0];
    if (this.count) this.times = [times.reduce((a, b) => Math.min(a, b)), times.reduce((a, b) => Math.max(a, b))];
    const sigmas = poses.sigma.filter(Number.isFinite).sort();
    this.hasConfidence = sigmas.length > 0;
    // From the smallest to nearly the largest sigma, so that a few lost poses do not flatten the scale.
    const rank = (share) => sigmas[Math.round(share * (sigmas.length - 1))];
    this.sigmas = this.hasConfidence ? [Math.max(rank(0), 1e-3), Math.max(rank(0.99), 2e-3)] : [1, 2];
    if (this.sigmas[1] < 1.5 * this.sigmas[0]) this.sigmas[1] = 1.5 * this.sigmas[0];
    this.tones = { time: this.tonesOf((k) => this.timeShare(k)), confidence: this.tonesOf((k) => this.sigmaShare(k)) };
  }

  /** Whether the pose is placed in the map. */
  isPlaced(k) {
    return this.poses.condition[k] !== kNotPlaced;
  }

  timeShare(k) {
    return (this.poses.t[k] - this.times[0]) / Math.max(this.times[1] - this.times[0], 1e-9);
  }

  sigmaShare(k) {
    const sigma = Math.max(this.poses.sigma[k], 1e-3);
    const [low, high] = this.sigmas.map(Math.log);
    return Number.isFinite(sigma) ? (Math.log(sigma) - low) / (high - low) : 1;
  }

  tonesOf(shareOf) {
    return Uint8Array.from({ length: this.count }, (_, k) =>
      Math.round(Math.min(1, Math.max(0, shareOf(k))) * (kNumRampColors - 1)));
  }

  /** Strokes the stretches that lead to poses which `belongs` picks. */
  stroke(context, columns, rows, belongs) {
    context.beginPath();
    let last = -2;
    for (let k = 1; k < this.count; ++k) {
      if (!belongs(k) || this.poses.begins.has(k)) continue;
      if (last !== k - 1) context.moveTo(columns[k - 1], rows[k - 1]);
      context.lineTo(columns[k], rows[k]);
      last = k;
    }
    context.stroke();
  }

  draw(context, view) {
    const columns = new Float32Array(this.count);
    const rows = new Float32Array(this.count);
    for (let k = 0; k < this.count; ++k) {
      columns[k] = view.column(this.poses.u[k]);
      rows[k] = view.row(this.poses.v[k]);
    }
    const width = Math.min(3.2, Math.max(1.3, 0.05 * view.scale));
    context.lineJoin = "round";  // a mitre would shoot out where the track jitters on the spot
    context.lineCap = width > 2 ? "round" : "butt";
    const { condition } = this.poses;
    context.globalAlpha = 0.6;
    for (const [code, name] of [[1, "degenerate"], [3, "lost"]]) {
      context.strokeStyle = themeColor(name);
      context.lineWidth = 2.5 * width + 6;
      this.stroke(context, columns, rows, (k) => condition[k] === code);
    }
    context.globalAlpha = 1;
    context.lineWidth = width;
    this.drawColored(context, view, columns, rows);
    context.setLineDash([5, 5]);
    context.strokeStyle = themeColor("lost");
    this.stroke(context, columns, rows, (k) => condition[k] === 3);
    context.setLineDash([]);
    this.drawRecovered(context, columns, rows);
    this.drawEnds(context, columns, rows);
  }

  /** One path per colour: some dozens of strokes, however many poses. What lies out of sight, or less
      than a pixel from what was drawn last, is left out. */
  drawColored(context, view, columns, rows) {
    const tones = this.tones[shared.colorBy];
    const colors = ramp(shared.colorBy === "time" ? "time" : "sigma");
    const paths = colors.map(() => new Path2D());
    const { width, height } = view;
    const isBeyond = (a, b, end) => (a < -9 && b < -9) || (a > end + 9 && b > end + 9);
    let from = 0;
    let tone = -1;  // Of the stretch before, where the line goes on from it.
    for (let k = 1; k < this.count; ++k) {
      if (!this.isPlaced(k) || !this.isPlaced(from) || this.poses.begins.has(k)) {
        from = k;
        tone = -1;
        continue;
      }
      const isNear = Math.abs(columns[k] - columns[from]) + Math.abs(rows[k] - rows[from]) < 1;
      if (isNear && k + 1 < this.count) continue;
      if (isBeyond(columns[from], columns[k], width) || isBeyond(rows[from], rows[k], height)) {
        tone = -1;
      } else {
        if (tones[k] !== tone) paths[tones[k]].moveTo(columns[from], rows[from]);
        paths[tones[k]].lineTo(columns[k], rows[k]);
        tone = tones[k];
      }
      from = k;
    }
    colors.forEach((color, k) => {
      context.strokeStyle = color;
      context.stroke(paths[k]);
    });
  }

  drawRecovered(context, columns, rows) {
    context.strokeStyle = themeColor("recovered");
    context.lineWidth = 2;
    context.beginPath();
    this.poses.condition.forEach((code, k) => {
      if (code !== 2) return;
      context.moveTo(columns[k] + 6, rows[k]);
      context.arc(columns[k], rows[k], 6, 0, 2 * Math.PI);
    });
    context.stroke();
  }

  drawEnds(context, columns, rows) {
    const marks = [["start", this.firstPlaced, 6.5], ["end", this.lastPlaced, 4.5]];
    for (const [name, k, radius] of marks) {
      if (k < 0) continue;
      for (const [color, size] of [["casing", radius + 2], [name, radius]]) {
        context.fillStyle = themeColor(color);
        context.beginPath();
        context.arc(columns[k], rows[k], size, 0, 2 * Math.PI);
        context.fill();
      }
    }
  }

  /** The pose nearest to a pixel and no farther than `reach`, or -1. */
  nearest(view, [column, row], reach) {
    let best = -1;
    let squared = reach * reach;
    for (let k = 0; k < this.count; ++k) {
      if (!this.isPlaced(k)) continue;
      const a = view.column(this.poses.u[k]) - column;
      const b = view.row(this.poses.v[k]) - row;
      if (a * a + b * b >= squared) continue;
      squared = a * a + b * b;
      best = k;
    }
    return best;
  }

  /** The pose whose stamp is nearest to a time, or -1. */
  at(time) {
    let best = -1;
    for (let k = 0; k < this.count; ++k) {
      if (best < 0 || Math.abs(this.poses.t[k] - time) < Math.abs(this.poses.t[best] - time)) best = k;
    }
    return best;
  }
}
