// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Numbers and terms in words.

const degrees = (rad) => (rad * 180) / Math.PI;
const kDegree = "\u00b0";
const kMinus = "\u2212";
const kSpace = "\u202f";  // Narrow, does not break.

const fixed = (value, decimals) => {
  const text = Math.abs(value).toFixed(decimals);
  return value < 0 && Number(text) !== 0 ? kMinus + text : text;
};
const whole = (count) => Math.round(count).toString().replace(/\B(?=(\d{3})+$)/g, kSpace);
const inMetres = (value, decimals = 2) => fixed(value, decimals) + " m";
const inDegrees = (rad, decimals = 1) => fixed(degrees(rad), decimals) + kDegree;
const counted = (count, one, many) => whole(count) + " " + (count === 1 ? one : many);

/** Seconds since the start of the run, as 0:07.3, 12:34.5 or 1:02:03.4. */
function clock(seconds, decimals = 1) {
  const unit = 10 ** decimals;
  const all = Math.round(Math.abs(seconds) * unit);
  const rest = ((all / unit) % 60).toFixed(decimals).padStart(decimals ? 3 + decimals : 2, "0");
  const minutes = Math.floor(all / unit / 60);
  const hours = Math.floor(minutes / 60);
  const text = hours ? hours + ":" + String(minutes % 60).padStart(2, "0") : String(minutes);
  return (seconds < 0 ? kMinus : "") + text + ":" + rest;
}

/** A length of time for reading: 12 s, 7.5 min, 3.2 h. */
function duration(seconds) {
  if (seconds < 90) return fixed(seconds, seconds < 10 ? 1 : 0) + " s";
  return seconds < 5400 ? fixed(seconds / 60, 1) + " min" : fixed(seconds / 3600, 1) + " h";
}

/** A sigma in the unit that suits it. */
const sigmaText = (m) => (m < 0.995 ? fixed(100 * m, m < 0.0995 ? 1 : 0) + " cm" : inMetres(m));

/** The stamp of the log, as its tables have it, to the ms. */
function stampText(start, seconds) {
  const [wholes, decimals] = start.split(".");
  const ms = Math.round(Number("0." + decimals) * 1000 + seconds * 1000);
  const carried = Math.floor(ms / 1000);
  return Number(wholes) + carried + "." + String(ms - 1000 * carried).padStart(3, "0");
}

const kConditions = ["tracked", "degenerate", "recovered", "lost", "not placed"];
const kNotPlaced = 4;

/** Number of poses not placed in the map. */
const numNotPlaced = (poses) => poses.condition.filter((code) => code === kNotPlaced).length;

const kWords = {
  "loop closure": "A place visited twice: the scan of the later visit was matched to that of the earlier one. It ties the two visits together and takes out the error that has built up between them.",
  accepted: "The match was verified, so the closure pulls at the map.",
  "one axis only": "Accepted, but the scans fix the position along one direction of the building only: along a bare corridor a shift goes unseen, and the other direction is left open.",
  outvoted: "Accepted when verified, but the finished map contradicts it: its weight fell below one half, and it hardly pulls.",
  refused: "A candidate that did not pass verification. It is shown, but does not touch the map.",
  weight: "How far the finished map believes a measurement, from 0 (not at all) to 1 (fully).",
  residual: "How far the closure's own pose is from where the finished map has the two scans: small where all measurements agree.",
  degenerate: "The scans did not fix the motion along one direction, as in a bare corridor. The heading is right, the length of the stretch is uncertain.",
  lost: "No scan matched: the pose is only carried on from the motion before.",
  "not placed": "Tracked, but as a piece of its own: where tracking restarted, the robot's place in the map is unknown. The map leaves these scans out.",
  recovered: "Found again by matching without any guess, after a gap or a fast turn.",
  confidence: "The standard deviation of the position along its least certain direction: two times out of three the position is better than that.",
  heading: "The direction in which the robot looks, in the map: 0" + kDegree + " along x, counter-clockwise.",
  "measured heading": "Read off the walls of one scan. Walls stand square, so it is known but for quarter turns; the one nearest to the fused heading is drawn.",
  "fused heading": "What the map uses: tracked turns and measured headings together. It does not drift.",
  "tracked heading": "By following the motion from scan to scan alone. Small errors add up: it drifts.",
  "building frame": "Walls that run one way and across. A building with a wing at an odd angle has several.",
  track: "Where the robot was at every scan.",
};

/** A word with its explanation, shown on hover and focus. */
function term(text, word = text) {
  const span = document.createElement("span");
  span.className = "term";
  span.tabIndex = 0;
  span.append(text);
  const tip = document.createElement("span");
  tip.setAttribute("role", "tooltip");
  tip.id = "tip-" + (term.count = (term.count || 0) + 1);
  tip.textContent = kWords[word] || word;
  span.setAttribute("aria-describedby", tip.id);
  span.append(tip);
  return span;
}

function element(tag, className, ...children) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  made.append(...children);
  return made;
}
