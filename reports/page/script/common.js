"use strict";

// What all pages have: their data, colours for dark and light, contents, marks of series, print.

const data = JSON.parse(document.getElementById("data").textContent);
const views = []; // of Vega

const longNumber = new Intl.NumberFormat("en", { maximumFractionDigits: 0 });
const shortNumber = new Intl.NumberFormat("en", { maximumSignificantDigits: 4 });

// Thousands separated, except for what names a thing: a tile, a year of bits.
function textOf(value) {
  if (value === null || value === undefined) return "";
  if (typeof value !== "number") return String(value);
  if (value !== 0 && Math.abs(value) < 1e-4) return value.toExponential(2);
  return (Math.abs(value) >= 1000 ? longNumber : shortNumber).format(value);
}

function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value !== null) element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

const symbols = [
  "M6 1a5 5 0 1 0 .01 0z", "M1.5 1.5h9v9h-9z", "M6 0l5 6-5 6-5-6z", "M6 1l5.5 10h-11z",
  "M6 11L.5 1h11z", "M4 0h4v4h4v4H8v4H4V8H0V4h4z", "M1 6l10-5.5v11z", "M11 6L1 .5v11z",
];

function symbol(i, kind) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 12 12");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", symbols[kind === "squares" ? 1 : (i + Math.floor(i / 8)) % symbols.length]);
  path.setAttribute("fill", `var(--series-${i % 8})`);
  svg.append(path);
  return svg;
}

function showContents() {
  const links = [...document.querySelectorAll("main > section > h2:not(.hidden)")].map((heading) =>
    make("a", { href: `#${heading.parentElement.id}` }, heading.textContent));
  document.getElementById("contents").append(...links);
}

function startTheme() {
  const button = document.getElementById("theme");
  const system = matchMedia("(prefers-color-scheme: dark)");
  let isDark = system.matches;
  const show = () => {
    document.documentElement.dataset.theme = isDark ? "dark" : "light";
    button.textContent = isDark ? "Light colours" : "Dark colours";
  };
  button.addEventListener("click", () => ((isDark = !isDark), show()));
  system.addEventListener("change", () => ((isDark = system.matches), show()));
  button.hidden = false;
  show();
}

// On paper two charts stand side by side; their letters keep their size.
function startPrinting() {
  const width = 330;
  const height = 170;
  const heights = new Map();
  addEventListener("beforeprint", () => views.forEach((view) => {
    heights.set(view, view.height());
    view.width(width).height(Math.min(height, view.height())).run();
  }));
  addEventListener("afterprint", () => {
    views.forEach((view) => view.height(heights.get(view)).run());
    dispatchEvent(new Event("resize"));
  });
}
