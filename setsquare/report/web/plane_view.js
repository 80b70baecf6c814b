// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A canvas as a window on a plane in m, y upwards: moved and zoomed by mouse, touch and keyboard.

class PlaneView {
  /** `box`: left, bottom, right, top in m of what `fit` shows. */
  constructor(canvas, box, { onChange, onClick = () => {}, onPoint = () => {}, controls = canvas.parentElement }) {
    this.canvas = canvas;
    this.onChange = onChange;
    this.onClick = onClick;
    this.onPoint = onPoint;
    this.pointers = new Map();
    this.isFitted = true;
    this.box = box;
    this.measure();
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    for (const name of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(name, (event) => this.release(event));
    }
    canvas.addEventListener("pointerleave", () => this.onPoint(null));
    canvas.addEventListener("keydown", (event) => this.key(event));
    for (const button of controls.querySelectorAll("[data-zoom]")) {
      button.addEventListener("click", () => this.command(button.dataset.zoom));
    }
    new ResizeObserver(() => this.measure()).observe(canvas);
  }

  /** Takes the canvas's size, in CSS pixels: asking it for each point would be slow. */
  measure() {
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    if (this.isFitted) this.fit();
    else this.onChange();
  }

  setBox(box) {
    this.box = box;
    this.fit();
  }

  /** Shows the whole box. */
  fit() {
    const [left, bottom, right, top] = this.box;
    const margin = Math.min(24, 0.06 * this.width);
    this.scale = Math.min((this.width - 2 * margin) / Math.max(right - left, 0.5),
                          (this.height - 2 * margin) / Math.max(top - bottom, 0.5));
    this.scale = Math.max(this.scale, 1e-3);
    this.fittedScale = this.scale;
    this.u = 0.5 * (left + right);
    this.v = 0.5 * (bottom + top);
    this.isFitted = true;
    this.onChange();
  }

  /** Pixel of a place in m. */
  column(u) { return 0.5 * this.width + (u - this.u) * this.scale; }
  row(v) { return 0.5 * this.height - (v - this.v) * this.scale; }
  /** Place in m of a pixel. */
  place(column, row) {
    return [this.u + (column - 0.5 * this.width) / this.scale,
            this.v - (row - 0.5 * this.height) / this.scale];
  }

  /** Zooms by a factor; the place under the pixel stays. */
  zoom(factor, column = 0.5 * this.width, row = 0.5 * this.height) {
    const [u, v] = this.place(column, row);
    const scale = Math.min(Math.max(this.scale * factor, 0.2 * this.fittedScale), 4000);
    this.u = u - (u - this.u) * (this.scale / scale);
    this.v = v - (v - this.v) * (this.scale / scale);
    this.scale = scale;
    this.isFitted = false;
    this.onChange();
  }

  shift(columns, rows) {
    this.u -= columns / this.scale;
    this.v += rows / this.scale;
    this.isFitted = false;
    this.onChange();
  }

  /** Moves a place into the middle unless it shows already, clear of the rim. */
  reveal(u, v) {
    const rim = 40;
    const column = this.column(u);
    const row = this.row(v);
    if (column > rim && row > rim && column < this.width - rim &&
        row < this.height - rim) return;
    this.u = u;
    this.v = v;
    this.isFitted = false;
    this.onChange();
  }

  command(name) {
    if (name === "fit") this.fit();
    else this.zoom(name === "in" ? 1.5 : 1 / 1.5);
  }

  wheel(event) {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 20 : event.deltaMode === 2 ? 400 : 1);
    const speed = event.ctrlKey ? 0.01 : 0.0018;  // A pinch on a touchpad comes as ctrl + wheel.
    this.zoom(Math.exp(-speed * Math.max(-400, Math.min(400, pixels))), event.offsetX, event.offsetY);
  }

  press(event) {
    if (event.pointerType === "mouse" && event.button !== 0) return;
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
    this.isDragged = this.pointers.size > 1;
    this.pressed = [event.offsetX, event.offsetY];
  }

  move(event) {
    const before = this.pointers.get(event.pointerId);
    const now = [event.offsetX, event.offsetY];
    if (!before) {
      this.onPoint(now);
      return;
    }
    const slack = event.pointerType === "touch" ? 10 : 4;
    if (!this.isDragged &&
        Math.hypot(now[0] - this.pressed[0], now[1] - this.pressed[1]) < slack) return;
    this.isDragged = true;
    this.onPoint(null);
    if (this.pointers.size === 2) {
      const [, other] = [...this.pointers].find(([id]) => id !== event.pointerId);
      const spread = (a) => Math.max(Math.hypot(a[0] - other[0], a[1] - other[1]), 10);
      this.zoom(spread(now) / spread(before), 0.5 * (before[0] + other[0]), 0.5 * (before[1] + other[1]));
      this.shift(0.5 * (now[0] - before[0]), 0.5 * (now[1] - before[1]));
    } else {
      this.shift(now[0] - before[0], now[1] - before[1]);
    }
    this.pointers.set(event.pointerId, now);
  }

  release(event) {
    if (!this.pointers.delete(event.pointerId)) return;
    if (!this.isDragged && event.type === "pointerup") {
      this.onClick([event.offsetX, event.offsetY], event.pointerType === "touch" ? 18 : 10);
    }
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = 60;
    const actions = {
      ArrowLeft: () => this.shift(step, 0),
      ArrowRight: () => this.shift(-step, 0),
      ArrowUp: () => this.shift(0, step),
      ArrowDown: () => this.shift(0, -step),
      "+": () => this.zoom(1.25),
      "=": () => this.zoom(1.25),
      "-": () => this.zoom(0.8),
      0: () => this.fit(),
      Home: () => this.fit(),
    };
    if (!actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  }
}
