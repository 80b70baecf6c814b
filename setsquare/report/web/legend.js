// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The legends of map and plot; that of the closures is their filter, too.

const entry = (...children) => element("span", "entry", ...children);

function drawnSwatch(shapes) {
  const swatch = element("span", "swatch");
  swatch.innerHTML = '<svg viewBox="0 0 26 16" width="26" height="16" aria-hidden="true">' + shapes + "</svg>";
  return swatch;
}
const lineSwatch = (color, width, dash = "") =>
  drawnSwatch('<path d="M2 8h22" stroke="var(--' + color + ')" stroke-width="' + width + '" stroke-dasharray="' + dash + '"/>');
const discSwatch = (color, radius = 5) => drawnSwatch('<circle cx="13" cy="8" r="' + radius + '" fill="var(--' + color + ')"/>');
const bandSwatch = (color, dash) => drawnSwatch('<path d="M2 8h22" stroke="var(--' + color +
  ')" stroke-width="11" opacity=".5"/><path d="M2 8h22" stroke="var(--' + dash + ')" stroke-width="2"/>');

/** Metres travelled and number of stretches of one status. */
function lengthIn(poses, code) {
  let metres = 0;
  for (let k = 1; k < poses.t.length; ++k) {
    if (poses.condition[k] === code && !poses.begins.has(k)) metres += Math.hypot(poses.x[k] - poses.x[k - 1], poses.y[k] - poses.y[k - 1]);
  }
  return { metres, count: stretches(poses, [code]).length };
}

class MapLegend {
  constructor(report, track) {
    this.track = track;
    const legend = document.getElementById("legend");
    this.ramp = element("span", "ramp");
    this.low = element("span", "count");
    this.high = element("span", "count");
    this.word = element("span", "");
    if (report.poses.t.length) {
      legend.append(entry(this.word, this.low, this.ramp, this.high), entry(discSwatch("start", 6), "start"), entry(discSwatch("end", 4.5), "end"));
    }
    this.addConditions(legend, report.poses);
    const filters = element("div", "filters", element("span", "", term("Closures", "loop closure"), " shown:"));
    filters.setAttribute("role", "group");
    filters.setAttribute("aria-label", "Closures shown");
    if (report.closures.count > 0) legend.append(filters);
    for (const kind of kKinds) filters.append(this.filter(kind, report.closures.sums[kind]));
    const update = () => this.update();
    kDark.addEventListener("change", update);
    shared.listeners.push((what) => what === "color" && update());
    update();
  }

  addConditions(legend, poses) {
    for (const [code, color, dash] of [[1, "degenerate", "time-1"], [3, "lost", "lost"]]) {
      const { metres, count } = lengthIn(poses, code);
      if (count === 0) continue;
      const length = inMetres(metres, 1) + " in " + counted(count, "stretch", "stretches");
      legend.append(entry(bandSwatch(color, dash), term(kConditions[code]), element("span", "count", length)));
    }
    if (numNotPlaced(poses) > 0) {
      legend.append(entry(term("not placed"), element("span", "count", counted(numNotPlaced(poses), "scan", "scans"))));
    }
    const recovered = lengthIn(poses, 2).count;
    if (recovered > 0) {
      const ring = drawnSwatch('<circle cx="13" cy="8" r="5.5" fill="none" stroke="var(--recovered)" stroke-width="2"/>');
      legend.append(entry(ring, term("recovered"), element("span", "count", counted(recovered, "time", "times"))));
    }
  }

  filter(kind, count) {
    const box = element("input");
    box.type = "checkbox";
    box.checked = true;
    box.disabled = count === 0;
    box.id = "filter-" + kind;
    box.addEventListener("change", () => {
      shared.kinds[kind] = box.checked;
      shared.changed("kinds");
    });
    const label = element("label", "", kKindNames[kind]);
    label.htmlFor = box.id;
    const name = term("", kKindNames[kind]);
    name.prepend(label);
    name.removeAttribute("tabindex");  // The box has the focus already.
    box.setAttribute("aria-describedby", name.getAttribute("aria-describedby"));
    return entry(box, swatchOfKind(kind), name, element("span", "count", whole(count)));
  }

  update() {
    const isTime = shared.colorBy === "time";
    this.ramp.style.background = rampGradient(isTime ? "time" : "sigma");
    const { times, sigmas } = this.track;
    this.word.replaceChildren(isTime ? term("track") : term("confidence"));
    this.low.textContent = isTime ? clock(times[0], 0) : sigmaText(sigmas[0]);
    this.high.textContent = isTime ? clock(times[1], 0) + " min:s" : sigmaText(sigmas[1]) + " or worse";
  }
}

function makeHeadingLegend(headings) {
  const legend = document.getElementById("heading-legend");
  if (headings.t.length === 0) return;
  legend.append(entry(lineSwatch("fused", 2), term("fused", "fused heading")),
                entry(lineSwatch("tracked", 2, "5 3"), term("tracked", "tracked heading")));
  const used = [...new Set(headings.frame)].filter((frame) => frame >= 0).sort((a, b) => a - b);
  for (const frame of used) {
    const direction = headings.frames[frame];
    const walls = direction === undefined ? "" : "walls at " + inDegrees(wrappedToQuarter(direction));
    legend.append(entry(discSwatch(frameColor(frame), 3), term("measured", "measured heading"),
                        used.length > 1 ? term("building frame " + (frame + 1), "building frame") : "",
                        element("span", "count", walls)));
  }
  legend.append(element("span", "count", "The fainter a point, the less it was believed."));
}
