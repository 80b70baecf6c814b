// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The map: picture, track, closures, the scans of the selected closure, a scale bar.

/** Puts a tip beside a pixel of its stage, or hides it where there is no text. */
function showTip(tip, text, [column, row] = [0, 0]) {
  tip.hidden = !text;
  if (!text) return;
  tip.textContent = text;
  const stage = tip.parentElement;
  const isRight = column + 24 + tip.offsetWidth > stage.clientWidth;
  const left = isRight ? Math.max(4, column - 14 - tip.offsetWidth) : column + 14;
  const top = Math.max(4, Math.min(row + 14, stage.clientHeight - tip.offsetHeight - 6));
  tip.style.transform = "translate(" + left + "px," + top + "px)";
}

class MapPanel {
  constructor(report, select) {
    this.report = report;
    this.select = select;
    this.canvas = document.getElementById("map");
    this.tip = document.getElementById("map-tip");
    this.ask = drawOnDemand(this.canvas, () => this.draw());
    this.image = new MapImage(report.map, this.ask);
    this.track = new TrackDrawing(report.poses);
    this.marks = new ClosureDrawing(report.closures, report.scans, report.gridHeading);
    this.view = new PlaneView(this.canvas, this.boxToShow(), {
      onChange: this.ask,
      onClick: (pixel, reach) => this.click(pixel, reach),
      onPoint: (pixel) => this.point(pixel),
    });
    this.doubts = new Doubts(report, (doubt) => {
      this.view.reveal(doubt.u, doubt.v);
      this.canvas.scrollIntoView({ block: "nearest" });
      this.ask();
    });
    shared.listeners.push((what) => this.hear(what));
  }

  /** Walls and track. */
  boxToShow() {
    const { map, poses } = this.report;
    const box = map ? [...map.walls] : [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = 0; k < poses.u.length; ++k) {
      box[0] = Math.min(box[0], poses.u[k]);
      box[1] = Math.min(box[1], poses.v[k]);
      box[2] = Math.max(box[2], poses.u[k]);
      box[3] = Math.max(box[3], poses.v[k]);
    }
    return Number.isFinite(box[0]) ? box : [-5, -5, 5, 5];
  }

  hear(what) {
    if (what === "selected" && shared.selected >= 0) {
      this.view.reveal(this.marks.u[shared.selected], this.marks.v[shared.selected]);
    }
    const pose = what === "pinned" ? this.track.at(shared.pointedTime) : -1;
    if (pose >= 0) this.view.reveal(this.report.poses.u[pose], this.report.poses.v[pose]);
    this.ask();
  }

  draw() {
    const context = sharpContext(this.canvas);
    context.fillStyle = themeColor("unknown");
    context.fillRect(0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    this.image.draw(context, this.view);
    this.track.draw(context, this.view);
    this.marks.draw(context, this.view);
    if (this.doubts) this.doubts.draw(context, this.view);
    const pointed = Number.isFinite(shared.pointedTime) ? this.track.at(shared.pointedTime) : -1;
    if (pointed >= 0) this.drawPointed(context, pointed);
    drawScaleBar(context, this.canvas, this.view.scale);
  }

  /** The robot at a pose: a ring, and a stroke the way it looks. */
  drawPointed(context, k) {
    const { u, v, h } = this.report.poses;
    const column = this.view.column(u[k]);
    const row = this.view.row(v[k]);
    const heading = h[k] - this.report.gridHeading;
    const robot = new Path2D();
    robot.arc(column, row, 8, 0, 2 * Math.PI);
    robot.moveTo(column + 8 * Math.cos(heading), row - 8 * Math.sin(heading));
    robot.lineTo(column + 20 * Math.cos(heading), row - 20 * Math.sin(heading));
    for (const [color, width] of [["casing", 5], ["pointed", 2]]) {
      context.strokeStyle = themeColor(color);
      context.lineWidth = width;
      context.stroke(robot);
    }
  }

  click(pixel, reach) {
    const closure = this.marks.nearest(this.view, pixel, reach);
    if (closure >= 0) this.select(closure);
    this.point(pixel);
  }

  point(pixel) {
    const doubt = pixel ? this.doubts.at(this.view, pixel) : null;
    if (doubt) {
      showTip(this.tip, "Doubt " + doubt.number + ", " + doubt.kind + "\n" + doubt.reason, pixel);
      return;
    }
    const closure = pixel ? this.marks.nearest(this.view, pixel, 8) : -1;
    const pose = pixel && closure < 0 ? this.track.nearest(this.view, pixel, 10) : -1;
    this.canvas.style.cursor = closure >= 0 ? "pointer" : "";
    showTip(this.tip, closure >= 0 ? this.closureText(closure) : pose >= 0 ? this.poseText(pose) : "", pixel || undefined);
  }

  closureText(k) {
    const { closures, scans } = this.report;
    return "Loop closure, " + kKindNames[closures.kind[k]] + (closures.axes[k] === "xy" ? "" : " (" + closures.axes[k] + ")") +
      "\n" + clock(scans.t[closures.i[k]]) + " and " + clock(scans.t[closures.j[k]]) + ", " +
      duration(closures.apart[k]) + " apart\nweight " + fixed(closures.weight[k], 2);
  }

  poseText(k) {
    const { poses } = this.report;
    const sigma = Number.isFinite(poses.sigma[k]) ? "\nposition known to " + sigmaText(poses.sigma[k]) : "";
    return "at " + clock(poses.t[k]) + ", " + kConditions[poses.condition[k]] + "\nx " + inMetres(poses.x[k]) +
      ", y " + inMetres(poses.y[k]) + ", heading " + inDegrees(wrapped(poses.h[k])) + sigma;
  }
}
