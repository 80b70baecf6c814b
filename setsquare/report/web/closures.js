// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What the page derives for a loop closure from the columns of the file.

const kKinds = ["accepted", "one-axis", "outvoted", "refused"];
const kKindNames = { accepted: "accepted", "one-axis": "one axis only", outvoted: "outvoted", refused: "refused" };
const kOutvotedBelow = 0.5;

/** Adds kind, apart (s between the visits), residual (m) and turnResidual (rad). */
function judgeClosures(closures, scans) {
  const count = closures.i.length;
  closures.count = count;
  closures.kind = [];
  closures.apart = new Float64Array(count);
  closures.residual = new Float64Array(count);
  closures.turnResidual = new Float64Array(count);
  for (let k = 0; k < count; ++k) {
    const i = closures.i[k];
    const j = closures.j[k];
    closures.kind[k] = !closures.accepted[k] ? "refused"
      : closures.weight[k] < kOutvotedBelow ? "outvoted"
      : closures.axes[k] !== "xy" ? "one-axis" : "accepted";
    closures.apart[k] = Math.abs(scans.t[j] - scans.t[i]);
    const placed = composed(poseOf(scans, i), poseOf(closures, k));
    const dx = placed.x - scans.x[j];
    const dy = placed.y - scans.y[j];
    const axes = closures.axes[k];
    closures.residual[k] = axes === "xy" ? Math.hypot(dx, dy) : Math.abs(axes === "x" ? dx : dy);
    closures.turnResidual[k] = Math.abs(wrapped(placed.h - scans.h[j]));
  }
  closures.sums = Object.fromEntries(kKinds.map((kind) => [kind, closures.kind.filter((a) => a === kind).length]));
}

const poseOf = (rows, k) => ({ x: rows.x[k], y: rows.y[k], h: rows.h[k] });

/** The pose of c in a, from that of b in a and that of c in b. */
function composed(a_b, b_c) {
  const c = Math.cos(a_b.h);
  const s = Math.sin(a_b.h);
  return { x: a_b.x + c * b_c.x - s * b_c.y, y: a_b.y + s * b_c.x + c * b_c.y, h: wrapped(a_b.h + b_c.h) };
}

/** The pose of c in b, from those of b and c in a. */
function between(a_b, a_c) {
  const c = Math.cos(a_b.h);
  const s = Math.sin(a_b.h);
  const dx = a_c.x - a_b.x;
  const dy = a_c.y - a_b.y;
  return { x: c * dx + s * dy, y: c * dy - s * dx, h: wrapped(a_c.h - a_b.h) };
}

/** Closures of the kinds that are switched on, in the order of the list. */
function shownClosures(closures, order, scans) {
  const keys = {
    time: (k) => scans.t[closures.j[k]],
    weight: (k) => closures.weight[k],
    residual: (k) => -closures.residual[k],
    apart: (k) => -closures.apart[k],
  };
  const shown = [];
  for (let k = 0; k < closures.count; ++k) if (shared.kinds[closures.kind[k]]) shown.push(k);
  return shown.sort((a, b) => keys[order](a) - keys[order](b) || a - b);
}
