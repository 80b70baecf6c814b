// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The pieces that sections are made of. A cell of a table is text, or {text, style}: "bad", "faint".

/** An HTML element; of the children those that are text are taken as text. */
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

function paragraph(...words) {
  return element("p", {}, ...words);
}

/** How to run a part again. */
function commandLine(words) {
  return element("pre", {}, element("code", {}, words));
}

function cell(tag, content, attributes = {}) {
  const { text, style } = typeof content === "object" ? content : { text: content, style: "" };
  // A number stays on one line with its unit.
  const words = String(text).replace(/(\d) (%|m|deg|ms)(?![a-z])/g, "$1\u00a0$2");
  return element(tag, style ? { ...attributes, class: style } : attributes, words);
}

/** A table with a line of words above; on a narrow screen it scrolls within its own box. */
function table({ caption, head, rows, style = "" }) {
  const made = element("table", style ? { class: style } : {});
  made.append(element("thead", {}, element("tr", {}, ...head.map((words) => cell("th", words, { scope: "col" })))));
  const body = element("tbody");
  for (const [first, ...others] of rows) {
    body.append(element("tr", {}, cell("th", first, { scope: "row" }), ...others.map((one) => cell("td", one))));
  }
  made.append(body);
  const box = element("div", { class: "table" });
  if (caption) box.append(paragraph(caption));
  box.append(element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": caption || "table" }, made));
  return box;
}

function figure(content, caption) {
  return element("figure", {}, content, element("figcaption", {}, caption));
}

/** A PNG picture from its bytes in base64. */
function picture(base64, words) {
  return element("img", { src: `data:image/png;base64,${base64}`, alt: words });
}

/** A part that opens on a click. */
function folding(title, ...content) {
  return element("details", {}, element("summary", {}, title), ...content);
}

function legend(names) {
  return element("ul", { class: "legend" },
    ...names.map((name, i) => element("li", { class: `s${1 + (i % 5)}` }, name)));
}

/** An SVG element. */
function shape(tag, attributes = {}, words = "") {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  if (words !== "") made.textContent = words;
  return made;
}

/** The width that a drawing has: all of a narrow screen, so that its letters keep their size. */
function widthFor(widest) {
  return Math.min(widest, document.getElementById("content").clientWidth - 28);
}
