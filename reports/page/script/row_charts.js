// Charts that have their own rows; one legend of series is for all of them.

const chosen = new Set(); // names; none: all are shown alike

const legend = data.names.map((name, i) => {
  const click = () => {
    if (!chosen.delete(name)) chosen.add(name);
    showChosen();
  };
  return make("button", { type: "button", "aria-pressed": "false", onclick: click }, symbol(i), name);
});

function showChosen() {
  legend.forEach((button, i) => {
    const on = chosen.has(data.names[i]);
    button.setAttribute("aria-pressed", String(on));
    button.classList.toggle("faint", chosen.size > 0 && !on);
  });
  for (const view of views) view.signal("chosen_s", chosen.size > 0 ? [...chosen] : null).runAsync();
}

async function start() {
  startTheme();
  startPrinting();
  showContents();
  document.getElementById("legend").append(...legend);
  for (const { id, spec, rows } of data.charts) {
    const options = { mode: "vega-lite", renderer: "svg", actions: false, config: data.config };
    const plot = document.querySelector(`#chart-${CSS.escape(id)} .plot`);
    views.push((await vegaEmbed(plot, { ...spec, data: { name: "rows", values: rows } }, options)).view);
  }
  document.documentElement.dataset.ready = String(Math.round(performance.now()));
}

start();
