// Starts the page; when all is drawn, <html data-ready> holds the milliseconds since it was opened.

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
