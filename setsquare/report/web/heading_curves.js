// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What the plot of headings shows, in degrees: curves, points and the range of its axis.

/** An angle to within an eighth of a turn of zero, by quarter turns. */
const wrappedToQuarter = (angle) => angle - 0.5 * Math.PI * Math.round(angle / (0.5 * Math.PI));

/** Symmetric about zero, so wide that all but the outermost share of the values lie within. */
function symmetricRange(values, share, least) {
  const sorted = Float64Array.from(values, Math.abs).sort();
  const reach = sorted.length ? sorted[Math.round(share * (sorted.length - 1))] : 0;
  const range = Math.max(least, 1.25 * reach);
  return [-range, range];
}

/** Of each view: `fused`, `tracked` (one per heading, or null), `points` (null where not measured). */
function headingCurves(headings) {
  const count = headings.t.length;
  const isMeasured = (k) => headings.frame[k] >= 0;
  const residual = Array.from({ length: count }, (_, k) =>
    isMeasured(k) ? wrappedToQuarter(headings.measured[k] - headings.fused[k]) : null);
  const drift = [];
  for (let k = 0; k < count; ++k) {
    const now = headings.tracked[k] - headings.fused[k];
    drift.push(k === 0 ? wrapped(now) : drift[k - 1] + wrapped(now - drift[k - 1]));
  }
  const inTurn = (rad) => degrees(wrapped(rad));
  const zero = new Array(count).fill(0);
  const believed = residual.filter((value, k) => value !== null && headings.weight[k] > 0.2);
  return {
    heading: {
      fused: Array.from(headings.fused, inTurn),
      tracked: Array.from(headings.tracked, inTurn),
      points: residual.map((value, k) => (value === null ? null : inTurn(headings.fused[k] + value))),
      range: [-190, 190],
      ticks: 90,
      isCyclic: true,
    },
    residual: {
      fused: zero,
      tracked: null,
      points: residual.map((value) => (value === null ? null : degrees(value))),
      range: symmetricRange(believed.map(degrees), 0.995, 1.5),
    },
    drift: {
      fused: zero,
      tracked: drift.map(degrees),
      points: null,
      range: symmetricRange(drift.map(degrees), 1, 1),
    },
  };
}

/** Stretches of poses of one status: from, to (s), code. */
function stretches(poses, codes) {
  const found = [];
  for (let k = 0; k < poses.t.length; ++k) {
    const code = poses.condition[k];
    if (!codes.includes(code)) continue;
    const last = found[found.length - 1];
    if (last && last.code === code && last.end === k - 1) {
      last.to = Math.max(last.to, poses.t[k]);
      last.end = k;
    } else {
      found.push({ from: poses.t[Math.max(k - 1, 0)], to: poses.t[k], code, end: k });
    }
  }
  return found;
}
