// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// How long a metre is on a canvas.

/** The greatest of 1, 2 and 5 times a power of ten that is not above a positive value. */
function niceBelow(value) {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  return power * (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1);
}

function drawScaleBar(context, canvas, scale) {
  const length = niceBelow(150 / scale);
  const text = length < 1 ? fixed(100 * length, 0) + " cm" : fixed(length, 0) + " m";
  const left = 16;
  const bottom = canvas.clientHeight - 16;
  const bar = new Path2D();
  bar.moveTo(left, bottom - 6);
  bar.lineTo(left, bottom);
  bar.lineTo(left + length * scale, bottom);
  bar.lineTo(left + length * scale, bottom - 6);
  context.font = "600 12.5px " + getComputedStyle(document.body).fontFamily;
  context.textAlign = "center";
  context.lineCap = context.lineJoin = "round";
  for (const [color, width] of [["casing", 5], ["ink", 1.8]]) {
    context.strokeStyle = context.fillStyle = themeColor(color);
    context.lineWidth = width;
    context.stroke(bar);
    const place = [text, left + 0.5 * length * scale, bottom - 8];
    if (color === "casing") context.strokeText(...place);
    else context.fillText(...place);
  }
}
