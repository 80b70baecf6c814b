// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A canvas as a window on a stretch of time; moved and zoomed like the map, but in time only.

const kPlotMargin = { left: 64, right: 14, top: 10, bottom: 30 };

class TimeView extends PlaneView {
  /** `times`: first and last s of what `fit` shows. */
  constructor(canvas, times, actions) {
    super(canvas, [times[0], 0, times[1], 0], actions);
  }

  length() { return Math.max(this.width - kPlotMargin.left - kPlotMargin.right, 1); }

  fit() {
    const length = Math.max(this.box[2] - this.box[0], 1);
    this.from = this.box[0] - 0.01 * length;
    this.scale = this.length() / (1.02 * length);
    this.fittedScale = this.scale;
    this.isFitted = true;
    this.onChange();
  }

  column(time) { return kPlotMargin.left + (time - this.from) * this.scale; }
  time(column) { return this.from + (column - kPlotMargin.left) / this.scale; }

  zoom(factor, column = kPlotMargin.left + 0.5 * this.length()) {
    const time = this.time(column);
    const scale = Math.min(Math.max(this.scale * factor, this.fittedScale), 400);
    this.from = time - (time - this.from) * (this.scale / scale);
    this.scale = scale;
    this.clamp();
    this.isFitted = false;
    this.onChange();
  }

  shift(columns) {
    this.from -= columns / this.scale;
    this.clamp();
    this.isFitted = false;
    this.onChange();
  }

  /** Never leaves the run. */
  clamp() {
    const slack = 0.01 * Math.max(this.box[2] - this.box[0], 1);
    const last = this.box[2] + slack - this.length() / this.scale;
    this.from = Math.max(Math.min(this.from, last), this.box[0] - slack);
  }
}
