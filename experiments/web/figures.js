// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Numbers as words. What is not known is null in paper.json and a dash here.

function number(value, decimals = 0) {
  return Number.isFinite(value) ? value.toFixed(decimals) : "-";
}

function percent(share, decimals = 2) {
  return Number.isFinite(share) ? `${(100 * share).toFixed(decimals)} %` : "-";
}

/** "2 of 3". */
function countOf(part, whole) {
  return `${part} of ${whole}`;
}

/** "0.0038 (0.0079)": mean and standard deviation. */
function meanAndSigma(spread, decimals) {
  return spread ? `${number(spread.mean, decimals)} (${number(spread.sigma, decimals)})` : "-";
}

function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = Math.floor(sorted.length / 2);
  return sorted.length % 2 === 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

function sum(values) {
  return values.reduce((total, value) => total + value, 0);
}

/** "0.012, 0.345": median and worst. */
function medianAndWorst(values, decimals) {
  return `${number(median(values), decimals)}, ${number(Math.max(...values), decimals)}`;
}

/** A count that should be 0. */
function fault(count, words = String(count)) {
  return { text: words, style: count === 0 ? "" : "bad" };
}

/** The highest y of all series, or `least` where that is higher. */
function highest(series, least) {
  const values = series.flatMap(({ points }) => points.map(([, y]) => y).filter(Number.isFinite));
  return Math.max(least, ...values);
}
