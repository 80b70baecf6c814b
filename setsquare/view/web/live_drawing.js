// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What is seen from above: the map, the way, closures, doubts, the robot and its scan.

class LiveDrawing {
  /** `said`: called with a pose {x, y, heading} that the user has set on the map. */
  constructor(said) {
    this.said = said;
    this.canvas = document.getElementById("map");
    this.ask = drawOnDemand(this.canvas, () => this.draw());
    this.map = { grid: [0, 0, 0], closures: [], doubts: [] };
    this.image = new MapImage(null, this.ask);
    this.way = [];
    this.pose = null;
    this.places = [];
    this.placing = null;  // While the user sets a pose: where, and which way.
    this.isPlacing = false;
    this.view = new PlaneView(this.canvas, [-5, -5, 5, 5], { onChange: this.ask });
    this.listen(document.getElementById("map-stage"));
  }

  show(map) {
    const image = new MapImage(map, () => {
      // Until then the last one stands.
      this.map = map;
      this.image = image;
      const box = [map.left, map.bottom, map.left + map.width * map.pixel, map.bottom + map.height * map.pixel];
      if (this.view.isFitted) this.view.setBox(box);
      else this.view.box = box;
      this.ask();
    });
  }

  showWay(points) {
    this.way = points;
    this.ask();
  }

  showPose(pose) {
    this.pose = pose;
    this.ask();
  }

  /** Where the robot may be, too: x, y, heading and probability of each. */
  showPlaces(places) {
    this.places = places;
    this.ask();
  }

  /** The pixel of a place of the map frame, in m. */
  pixel(x, y) {
    const [left, bottom, turn] = this.map.grid;
    const c = Math.cos(turn);
    const s = Math.sin(turn);
    return [this.view.column(c * (x - left) + s * (y - bottom)),
            this.view.row(-s * (x - left) + c * (y - bottom))];
  }

  /** The place of a pixel. */
  place(column, row) {
    const [left, bottom, turn] = this.map.grid;
    const [u, v] = this.view.place(column, row);
    const c = Math.cos(turn);
    const s = Math.sin(turn);
    return [left + c * u - s * v, bottom + s * u + c * v];
  }

  draw() {
    const context = sharpContext(this.canvas);
    context.fillStyle = themeColor("unknown");
    context.fillRect(0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    this.image.draw(context, this.view);
    this.drawWay(context);
    for (const closure of this.map.closures) this.drawClosure(context, closure);
    for (const place of this.places) this.drawPlace(context, place);
    if (this.pose?.placed) {
      this.drawScan(context);
      this.drawRobot(context, this.pose, "recovered");
    }
    this.drawDoubts(context);
    if (this.placing) this.drawRobot(context, this.placing, "start");
    drawScaleBar(context, this.canvas, this.view.scale);
  }

  drawWay(context) {
    const line = new Path2D();
    for (let k = 0; k + 1 < this.way.length; k += 2) line.lineTo(...this.pixel(this.way[k], this.way[k + 1]));
    context.lineJoin = context.lineCap = "round";
    context.strokeStyle = themeColor("time-1");
    context.lineWidth = 2;
    context.stroke(line);
  }

  drawClosure(context, [x0, y0, x1, y1, isBelieved]) {
    const line = new Path2D();
    line.moveTo(...this.pixel(x0, y0));
    line.lineTo(...this.pixel(x1, y1));
    context.strokeStyle = themeColor(isBelieved ? "accepted" : "outvoted");
    context.lineWidth = 1.5;
    context.stroke(line);
  }

  drawScan(context) {
    const { x, y, heading, scan } = this.pose;
    const c = Math.cos(heading);
    const s = Math.sin(heading);
    context.fillStyle = themeColor("current");
    for (let k = 0; k + 1 < scan.length; k += 2) {
      const [column, row] = this.pixel(x + c * scan[k] - s * scan[k + 1], y + s * scan[k] + c * scan[k + 1]);
      context.fillRect(column - 1.25, row - 1.25, 2.5, 2.5);
    }
  }

  /** A disc, and a stroke the way it looks. */
  drawRobot(context, { x, y, heading }, color) {
    const [column, row] = this.pixel(x, y);
    const turn = heading - this.map.grid[2];
    const body = new Path2D();
    body.arc(column, row, 7, 0, 2 * Math.PI);
    const nose = new Path2D();
    nose.moveTo(column, row);
    nose.lineTo(column + 18 * Math.cos(turn), row - 18 * Math.sin(turn));
    context.lineCap = "round";
    for (const [name, width] of [["casing", 7], [color, 3.5]]) {
      context.strokeStyle = context.fillStyle = themeColor(name);
      context.lineWidth = width;
      context.stroke(nose);
      if (name === "casing") context.stroke(body);
      context.fill(body);
    }
  }

  /** A robot that is fainter the less probable it is, with its probability beside it. */
  drawPlace(context, [x, y, heading, probability]) {
    context.globalAlpha = 0.4 + 0.6 * probability;
    this.drawRobot(context, { x, y, heading }, "lost");
    context.globalAlpha = 1;
    const [column, row] = this.pixel(x, y);
    context.font = "600 12px system-ui, sans-serif";
    context.textBaseline = "middle";
    context.lineWidth = 4;
    context.strokeStyle = themeColor("casing");
    context.fillStyle = themeColor("ink");
    const text = Math.round(100 * probability) + " %";
    context.strokeText(text, column + 12, row + 12);
    context.fillText(text, column + 12, row + 12);
  }

  drawDoubts(context) {
    context.strokeStyle = themeColor("doubt");
    context.lineWidth = 3;
    for (const { x, y } of this.map.doubts) {
      const [column, row] = this.pixel(x, y);
      const cross = new Path2D();
      cross.moveTo(column - 8, row - 8);
      cross.lineTo(column + 8, row + 8);
      cross.moveTo(column - 8, row + 8);
      cross.lineTo(column + 8, row - 8);
      context.stroke(cross);
    }
  }

  // --- A pose that the user sets: pressed where the robot is, drawn the way it looks ---

  setPlacing(isPlacing) {
    this.isPlacing = isPlacing;
    this.placing = null;
    this.ask();
  }

  /** Before the canvas, which would move. */
  listen(stage) {
    const steps = { pointerdown: "begin", pointermove: "turn", pointerup: "say" };
    for (const [name, step] of Object.entries(steps)) {
      stage.addEventListener(name, (event) => {
        if (!this.isPlacing || event.target !== this.canvas) return;
        event.stopPropagation();
        this[step](event);
      }, true);
    }
  }

  begin(event) {
    this.canvas.setPointerCapture(event.pointerId);
    const [x, y] = this.place(event.offsetX, event.offsetY);
    this.placing = { x, y, heading: this.map.grid[2] };
    this.ask();
  }

  turn(event) {
    if (!this.placing) return;
    const [x, y] = this.place(event.offsetX, event.offsetY);
    const isFar = Math.hypot(x - this.placing.x, y - this.placing.y) * this.view.scale > 5;
    if (isFar) this.placing.heading = Math.atan2(y - this.placing.y, x - this.placing.x);
    this.ask();
  }

  say() {
    const pose = this.placing;
    if (pose) this.said(pose);
  }
}
