// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The report as map_report_json (page_data.cpp) wrote it, into plain arrays in m, rad and s.

/** Numbers of one column; see `packed` in page_data.hpp. */
function unpackNumbers(text) {
  const bytes = atob(text);
  const values = [];
  let value = 0;
  let folded = 0;
  let scale = 1;
  for (let i = 0; i < bytes.length; ++i) {
    const byte = bytes.charCodeAt(i);
    folded += (byte & 127) * scale;
    scale *= 128;
    if (byte & 128) continue;
    value += folded % 2 ? -(folded + 1) / 2 : folded / 2;
    values.push(value);
    folded = 0;
    scale = 1;
  }
  return values;
}

const unpackColumn = (text, step) => Float64Array.from(unpackNumbers(text), (n) => n * step);

const kMillimetre = 1e-3;
const kCentimetre = 1e-2;
const kTenthOfMilliradian = 1e-4;
const kThousandth = 1e-3;

/** t, x, y, h of rows with a stamp and a pose in the map frame. */
function unpackPoses(rows) {
  return {
    t: unpackColumn(rows.t, kThousandth),
    x: unpackColumn(rows.x, kMillimetre),
    y: unpackColumn(rows.y, kMillimetre),
    h: unpackColumn(rows.h, kTenthOfMilliradian),
  };
}

/** Adds u, v: positions on the upright page, whose axes run along the grid's rows and columns. */
function addUpright(poses, gridHeading) {
  const c = Math.cos(gridHeading);
  const s = Math.sin(gridHeading);
  poses.u = poses.x.map((x, k) => c * x + s * poses.y[k]);
  poses.v = poses.x.map((x, k) => c * poses.y[k] - s * x);
}

const wrapped = (angle) => angle - 2 * Math.PI * Math.floor((angle + Math.PI) / (2 * Math.PI));

function unpackScans(rows) {
  const scans = unpackPoses(rows);
  scans.points = unpackNumbers(rows.points);
  scans.first = [];
  scans.points.reduce((first, count, k) => (scans.first[k] = first) + count, 0);
  scans.px = unpackColumn(rows.px, kCentimetre);
  scans.py = unpackColumn(rows.py, kCentimetre);
  return scans;
}

function unpackClosures(rows) {
  return {
    i: unpackNumbers(rows.i),
    j: unpackNumbers(rows.j),
    x: unpackColumn(rows.x, kMillimetre),
    y: unpackColumn(rows.y, kMillimetre),
    h: unpackColumn(rows.h, kTenthOfMilliradian),
    axes: unpackNumbers(rows.axes).map((k) => ["xy", "x", "y"][k]),
    accepted: unpackNumbers(rows.accepted),
    weight: unpackColumn(rows.weight, kThousandth),
    reason: unpackNumbers(rows.reason).map((k) => rows.reasons[k]),
  };
}

function unpackHeadings(rows) {
  return {
    t: unpackColumn(rows.t, kThousandth),
    measured: unpackColumn(rows.measured, kTenthOfMilliradian),
    frame: unpackNumbers(rows.frame),
    weight: unpackColumn(rows.weight, kThousandth),
    fused: unpackColumn(rows.fused, kTenthOfMilliradian),
    tracked: unpackColumn(rows.tracked, kTenthOfMilliradian),
    frames: rows.frames,
  };
}

function unpackDoubts(rows, gridHeading) {
  const places = { x: rows.map((row) => row.x), y: rows.map((row) => row.y) };
  addUpright(places, gridHeading);
  return rows.map((row, k) => ({ ...row, number: k + 1, u: places.u[k], v: places.v[k] }));
}

function unpackReport(json) {
  const poses = unpackPoses(json.poses);
  poses.condition = unpackNumbers(json.poses.condition);
  poses.begins = new Set(json.begins);  // nothing is known of the way to these
  poses.sigma = unpackColumn(json.poses.sigma, kMillimetre).map((m) => (m < 0 ? NaN : m));
  const scans = unpackScans(json.scans);
  addUpright(poses, json.grid_heading);
  addUpright(scans, json.grid_heading);
  return {
    title: json.title,
    start: json.start,
    gridHeading: json.grid_heading,
    map: json.map,
    poses,
    scans,
    closures: unpackClosures(json.closures),
    headings: unpackHeadings(json.headings),
    figures: json.figures,
    verdict: json.verdict,
    doubts: unpackDoubts(json.doubts, json.grid_heading),
  };
}
