// SPDX-License-Identifier: Apache-2.0
// Elements, numbers and units, for all live pages. Texts go into pages as
// texts and never as HTML.

function byId(name) {
  return document.getElementById(name);
}

function setAll(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined)
      element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

function make(tag, attributes = {}, ...children) {
  return setAll(document.createElement(tag), attributes, children);
}

function makeSvg(tag, attributes = {}, ...children) {
  return setAll(
    document.createElementNS("http://www.w3.org/2000/svg", tag),
    attributes, children);
}

const RAISED = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³" };

// "MJ m-2 day-1" becomes "MJ/m²/day".
function plainUnit(unit) {
  if (unit === "1") return "";
  const [over, under] = [[], []];
  for (const word of unit.split(" ")) {
    const [, name, power] = /^(.*?)(-?\d*)$/.exec(word);
    const size = power.replace("-", "");
    const text = name + (size && size !== "1"
      ? [...size].map((c) => RAISED[c] || c).join("") : "");
    (power.startsWith("-") ? under : over).push(text);
  }
  return [over.join(" ") || "1", ...under].join("/");
}

// Half of a 95 % confidence interval, the meaning of "±" on all pages.
const halfWidth = (standardError) => 1.96 * (standardError || 0);

// The digits after the point that a number with such an error needs.
function digitsFor(value, error) {
  if (error > 0) {
    const shift = error > Math.abs(value) * 0.2 ? 0 : 1;
    return Math.min(6, Math.max(0, shift - Math.floor(Math.log10(error))));
  }
  if (!value) return 0;
  return Math.min(6, Math.max(0, 2 - Math.floor(Math.log10(Math.abs(value)))));
}

function formatNumber(value, error = 0) {
  if (value === null || value === undefined) return "–";
  return value.toFixed(digitsFor(value, error)).replace("-", "−");
}

function formatError(value, error) {
  return error > 0 ? `± ${error.toFixed(digitsFor(value, error))}` : "";
}

function formatSigned(value, digits) {
  const text = Math.abs(value).toFixed(digits);
  return Number(text) === 0 ? text : (value < 0 ? "−" : "+") + text;
}

function formatDuration(seconds) {
  if (seconds < 90) return `${Math.round(seconds)} s`;
  if (seconds < 5400) return `${Math.round(seconds / 60)} min`;
  if (seconds < 172800) return `${(seconds / 3600).toFixed(1)} h`;
  return `${(seconds / 86400).toFixed(1)} days`;
}

// Shows a message, which screen readers also read aloud.
function announce(text, isBad = false) {
  const place = byId("notice");
  place.textContent = text;
  place.classList.toggle("bad", isBad);
  place.hidden = !text;
}
