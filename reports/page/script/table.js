// The table of points: sorted by any column, filtered by the selection and by words, a page at a
// time; a point's whole configuration and results open below it.

const pageLength = 50;

const table = {
  keys: data.table,
  sort: { key: null, down: false },
  page: 0,
  points: [],
};

function cellText(key, point) {
  const column = columns.get(key);
  const value = valueAt(key, point);
  const isName = column.kind === "setting" || column.kind === "frame";
  return isName && typeof value === "number" && Math.abs(value) < 10000 ? String(value) : textOf(value);
}

function isNumber(key) {
  const column = columns.get(key);
  return !column.words && typeof (column.values?.find((value) => value !== null) ?? column.all) === "number";
}

// "tile=8 bunny": each word must be in some cell; with "=", in that column, and all of it.
function matcher(text) {
  const tests = text.toLowerCase().split(/\s+/).filter(Boolean).map((word) => {
    const [name, value] = word.split("=");
    if (value === undefined) {
      return (point) => table.keys.some((key) => String(valueAt(key, point) ?? "").toLowerCase().includes(word));
    }
    const found = data.columns.find((column) => [column.key, column.label, column.key.split(".").pop()].includes(name));
    return (point) => found !== undefined && String(valueAt(found.key, point) ?? "").toLowerCase() === value;
  });
  return (point) => tests.every((test) => test(point));
}

function compare(a, b) {
  if (a === b) return 0;
  if (a === null) return 1;
  if (b === null) return -1;
  return typeof a === "number" && typeof b === "number" ? a - b : String(a) < String(b) ? -1 : 1;
}

function findPoints() {
  const matches = matcher(document.getElementById("search").value);
  table.points = [];
  for (let point = 0; point < data.points; ++point) {
    if (selection.admits(point) && matches(point)) table.points.push(point);
  }
  const { key, down } = table.sort;
  if (key !== null) {
    table.points.sort((a, b) => {
      const [x, y] = [valueAt(key, a), valueAt(key, b)];
      const nothing = (y === null) - (x === null);
      return nothing !== 0 ? -nothing : (down ? -compare(x, y) : compare(x, y)) || a - b;
    });
  }
}

function headerCell(key) {
  const column = columns.get(key);
  const sorted = table.sort.key === key ? (table.sort.down ? "descending" : "ascending") : "none";
  const click = () => {
    table.sort = { key, down: table.sort.key === key && !table.sort.down };
    table.page = 0;
    showTable();
    document.querySelector(`#table th[data-key="${CSS.escape(key)}"] button`).focus();
  };
  const unit = column.unit ? [make("small", {}, column.unit)] : [];
  return make("th", { scope: "col", class: isNumber(key) ? "number" : null, "aria-sort": sorted, "data-key": key },
    make("button", { type: "button", title: `Sort by ${key}`, onclick: click }, column.label), ...unit);
}

function detailList(heading, kind, point) {
  const entries = data.columns.filter((column) => column.kind === kind && (valueAt(column.key, point) ?? "") !== "");
  const rows = entries.map((column) =>
    make("div", {}, make("dt", {}, column.key), make("dd", {}, cellText(column.key, point))));
  return rows.length > 0 ? [make("h3", {}, heading), make("dl", {}, ...rows)] : [];
}

function detailsRow(point) {
  const cell = make("td", { colspan: table.keys.length + 1, class: "details" },
    ...detailList("Point", "point", point), ...detailList("Frame", "frame", point),
    ...detailList("Effective configuration", "setting", point), ...detailList("Results", "metric", point),
    ...(data.whole ? [] : ["More metrics are in the files below."]));
  return make("tr", { class: "details" }, cell);
}

function pointRow(point) {
  const open = make("button", { type: "button", class: "open", "aria-expanded": "false",
    "aria-label": `Configuration of point ${point + 1}` }, "+");
  const cells = table.keys.map((key) => make("td", { class: isNumber(key) ? "number" : null }, cellText(key, point)));
  const row = make("tr", { class: isDone(point) ? null : "failed" }, make("td", {}, open), ...cells);
  open.addEventListener("click", () => {
    const isOpen = open.getAttribute("aria-expanded") === "true";
    open.setAttribute("aria-expanded", String(!isOpen));
    open.textContent = isOpen ? "+" : "−";
    if (isOpen) row.nextElementSibling.remove();
    else row.after(detailsRow(point));
  });
  return row;
}

function showTable() {
  findPoints();
  const pages = Math.max(1, Math.ceil(table.points.length / pageLength));
  table.page = Math.min(table.page, pages - 1);
  const first = table.page * pageLength;
  const points = table.points.slice(first, first + pageLength);
  const head = make("thead", {}, make("tr", {}, make("td", {}), ...table.keys.map(headerCell)));
  const body = make("tbody", {}, ...points.map(pointRow));
  document.getElementById("table").replaceChildren(make("table", {}, head, body));
  const of = table.points.length === data.points ? "" : ` of ${textOf(data.points)}`;
  document.getElementById("rows").textContent = `${textOf(table.points.length)}${of} points`;
  document.getElementById("paper").textContent = pages === 1 ? "" :
    `Here are points ${textOf(first + 1)} to ${textOf(first + points.length)} of ${textOf(table.points.length)}.`;
  showPager(pages, first, points.length);
}

function showPager(pages, first, count) {
  const pager = document.querySelector(".pager");
  if (pages === 1) return pager.replaceChildren();
  const turn = (text, page, isOff) => {
    const click = () => {
      table.page = page;
      showTable();
      [...pager.querySelectorAll("button")].find((b) => b.textContent === text && !b.disabled)?.focus();
    };
    return make("button", { type: "button", disabled: isOff ? "" : null, onclick: click }, text);
  };
  pager.replaceChildren(
    turn("Previous", table.page - 1, table.page === 0),
    `${textOf(first + 1)}–${textOf(first + count)}`,
    turn("Next", table.page + 1, table.page === pages - 1));
}

function csvField(value) {
  const text = value === null || value === undefined ? "" : String(value);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

function saveTable() {
  const keys = ["key", ...table.keys];
  const lines = [keys, ...table.points.map((point) => keys.map((key) => valueAt(key, point)))];
  const text = lines.map((line) => line.map(csvField).join(",") + "\n").join("");
  const link = make("a", { href: URL.createObjectURL(new Blob([text], { type: "text/csv" })), download: `${data.name}-points.csv` });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function startTable() {
  document.getElementById("search").addEventListener("input", () => ((table.page = 0), showTable()));
  document.getElementById("save").addEventListener("click", saveTable);
  selection.followers.push(() => ((table.page = 0), showTable()));
  showTable();
}
