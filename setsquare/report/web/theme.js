// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Colours: the style sheet's custom properties, light or dark, and ramps between them.

const kDark = window.matchMedia("(prefers-color-scheme: dark)");
const kNumRampColors = 48;

/** The style sheet's colour of that name, as #rrggbb. */
const themeColor = (() => {
  let known = new Map();
  kDark.addEventListener("change", () => (known = new Map()));
  return (name) => {
    if (!known.has(name)) {
      const style = getComputedStyle(document.documentElement);
      known.set(name, style.getPropertyValue("--" + name).trim());
    }
    return known.get(name);
  };
})();

const channels = (hex) => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16));

function mixed(from, to, share) {
  const a = channels(from);
  const b = channels(to);
  return "rgb(" + a.map((value, k) => Math.round(value + (b[k] - value) * share)).join(",") + ")";
}

/** The colours from name-0 to name-3, evenly. */
function ramp(name) {
  const stops = [0, 1, 2, 3].map((k) => themeColor(name + "-" + k));
  return Array.from({ length: kNumRampColors }, (_, k) => {
    const place = (3 * k) / (kNumRampColors - 1);
    const stop = Math.min(2, Math.floor(place));
    return mixed(stops[stop], stops[stop + 1], place - stop);
  });
}

const rampGradient = (name) => "linear-gradient(90deg, " + ramp(name).join(",") + ")";

/** State that several panels share; `changed` calls the listeners. */
const shared = {
  colorBy: "time",
  kinds: { accepted: true, "one-axis": true, outvoted: true, refused: true },
  selected: -1,  // Closure.
  placing: "closure",
  pointedTime: NaN,  // In s, where a pointer rests on the heading's plot.
  listeners: [],
  changed(what) {
    for (const listener of this.listeners) listener(what);
  },
};

/** The canvas's context, in CSS pixels, its store as sharp as the screen. */
function sharpContext(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
  return context;
}

/** Calls `draw` once before the next frame, however often it is asked; again on a new theme. */
function drawOnDemand(canvas, draw) {
  let isAsked = false;
  const ask = () => {
    if (isAsked) return;
    isAsked = true;
    requestAnimationFrame(() => {
      isAsked = false;
      draw();
    });
  };
  kDark.addEventListener("change", ask);
  new ResizeObserver(ask).observe(canvas);
  return ask;
}
