// Starts the page; when all is drawn, <html data-ready> holds the milliseconds since it was opened.

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

async function start() {
  startTheme();
  startPrinting();
  showContents();
  showFilters();
  showMaps();
  startTable();
  for (const chart of data.charts) await showChart(chart);
  document.documentElement.dataset.ready = String(Math.round(performance.now()));
}

start();
