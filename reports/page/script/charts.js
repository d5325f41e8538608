// Charts: rows for Vega-Lite from the columns, under the selection. A chart does not drop what its
// own x and series tell apart; it draws the rest fainter.

function ownKeys(chart) {
  return [chart.x, chart.series].filter((key) => key !== null);
}

function rowsOf(chart) {
  const own = ownKeys(chart);
  const held = chart.held.filter(([key]) => !selection.chosen.has(key));
  const names = chart.series === null ? null : new Map(chart.values.map((value, i) => [value, chart.names[i]]));
  const rows = [];
  for (let point = 0; point < data.points; ++point) {
    if (!isDone(point) || !selection.admits(point, own)) continue;
    if (!held.every(([key, value]) => valueAt(key, point) === value)) continue;
    const per = chart.per === null ? 1 : valueAt(chart.per, point);
    for (const measure of chart.measures) {
      const y = valueAt(measure.key, point);
      const x = chart.x === null ? measure.at : valueAt(chart.x, point);
      if (typeof y !== "number" || x === null || !per) continue;
      const s = names ? names.get(valueAt(chart.series, point)) : chart.measures.length > 1 ? measure.name : "";
      rows.push({ x, s, y: y / per, scene: valueAt("scene", point), frame: valueAt("frame_label", point) });
    }
  }
  return rows;
}

function heldText(chart, isEmpty) {
  if (isEmpty) return "No point with this selection.";
  const said = chart.held.filter(([key, value]) => value !== null || selection.chosen.has(key));
  const parts = said.map(([key, value]) => {
    const values = selection.chosen.has(key) ? [...selection.chosen.get(key)] : [value];
    return `${columns.get(key).label} ${values.map(textOf).join(" or ")}`;
  });
  return parts.length > 0 ? `With ${parts.join(", ")}.` : "";
}

// The legend: a button a series. Series of settings are chosen for the whole page, others here.
function showSeries(chart, figure, redraw) {
  if (chart.names.length < 2) return;
  const shared = selection.dimensions.includes(chart.series);
  chart.local = new Set();
  const buttons = chart.names.map((name, i) => {
    const click = () => {
      if (shared) return selection.toggle(chart.series, chart.values[i]);
      if (!chart.local.delete(name)) chart.local.add(name);
      redraw();
    };
    const mark = chart.spec.usermeta.symbols === "none" ? [] : [symbol(i, chart.spec.usermeta.symbols)];
    return make("button", { type: "button", "aria-pressed": "false", onclick: click }, ...mark, name);
  });
  figure.querySelector(".series").append(...buttons);
  chart.showPressed = (chosen) => {
    buttons.forEach((button, i) => {
      const on = chosen?.includes(chart.names[i]) ?? false;
      button.setAttribute("aria-pressed", String(on));
      button.classList.toggle("faint", chosen !== null && !on);
    });
  };
}

function chosenSeries(chart) {
  if (chart.series === null) return chart.local?.size > 0 ? [...chart.local] : null;
  if (!selection.chosen.has(chart.series)) return null;
  return chart.names.filter((_, i) => selection.has(chart.series, chart.values[i]));
}

async function showChart(chart) {
  const figure = document.getElementById(`chart-${chart.id}`);
  let view = null;
  const redraw = () => {
    const rows = rowsOf(chart);
    const series = chosenSeries(chart);
    const xs = selection.chosen.get(chart.x);
    figure.classList.toggle("empty", rows.length === 0);
    figure.querySelector(".held").textContent = heldText(chart, rows.length === 0);
    chart.showPressed?.(series);
    if (!view) return rows;
    view.data("rows", rows).signal("chosen_s", series).signal("chosen_x", xs ? [...xs] : null);
    return view.runAsync();
  };
  showSeries(chart, figure, redraw);
  const spec = { ...chart.spec, data: { name: "rows", values: redraw() } };
  const options = { mode: "vega-lite", renderer: "svg", actions: false, config: data.config };
  ({ view } = await vegaEmbed(figure.querySelector(".plot"), spec, options));
  views.push(view);
  view.addEventListener("click", (_, item) => {
    const datum = item?.datum;
    if (!datum || !("s" in datum)) return;
    const i = chart.names.indexOf(datum.s);
    const pairs = [[chart.x, datum.x]];
    if (chart.series !== null) pairs.push([chart.series, chart.values[i]]);
    selection.toggleOnly(pairs);
  });
  selection.followers.push(redraw);
}
