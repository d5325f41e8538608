// What the reader has chosen: values of settings and scenes that the charts, the heat maps and the
// table follow.

const columns = new Map(data.columns.map((column) => [column.key, column]));

function valueAt(key, point) {
  const column = columns.get(key);
  if ("all" in column) return column.all;
  return column.words ? column.words[column.at[point]] : column.values[point];
}

function isDone(point) {
  return valueAt("state", point) === "done";
}

const selection = {
  dimensions: ["scene", ...data.axes].filter((key) => columns.get(key)?.distinct?.length > 1),
  chosen: new Map(), // key -> Set of values; a key without values is not there
  followers: [], // called after each change

  has(key, value) {
    return this.chosen.get(key)?.has(value) ?? false;
  },
  choose(key, value, on) {
    if (!this.dimensions.includes(key)) return;
    const values = this.chosen.get(key) ?? new Set();
    if (on) values.add(value);
    else values.delete(value);
    if (values.size > 0) this.chosen.set(key, values);
    else this.chosen.delete(key);
  },
  toggle(key, value) {
    this.choose(key, value, !this.has(key, value));
    this.changed();
  },
  // One value of each key; all of them off if they are what is chosen already.
  toggleOnly(pairs) {
    const known = pairs.filter(([key]) => this.dimensions.includes(key));
    const same = known.every(([key, value]) => this.chosen.get(key)?.size === 1 && this.has(key, value));
    for (const [key, value] of known) {
      this.chosen.delete(key);
      if (!same) this.choose(key, value, true);
    }
    this.changed();
  },
  clear() {
    this.chosen.clear();
    this.changed();
  },
  changed() {
    for (const follower of this.followers) follower();
  },
  // Does a point agree with what is chosen, keys in `except` aside?
  admits(point, except = []) {
    for (const [key, values] of this.chosen) {
      if (!except.includes(key) && !values.has(valueAt(key, point))) return false;
    }
    return true;
  },
};

// A menu of check boxes for each dimension, and what is chosen as buttons that take it away.
function showFilters() {
  const filters = document.getElementById("filters");
  const label = (key) => columns.get(key).label;
  for (const key of selection.dimensions) {
    const boxes = columns.get(key).distinct.map((value) => {
      const box = make("input", { type: "checkbox", onchange: () => selection.toggle(key, value) });
      selection.followers.push(() => (box.checked = selection.has(key, value)));
      return make("label", {}, box, textOf(value));
    });
    const summary = make("summary", {}, label(key));
    const legend = make("legend", { class: "hidden" }, `Show only this ${label(key)}`);
    const menu = make("details", {}, summary, make("fieldset", {}, legend, ...boxes));
    menu.addEventListener("toggle", () => menu.open && closeOthers(menu));
    menu.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      menu.open = false;
      summary.focus();
    });
    selection.followers.push(() => menu.classList.toggle("used", selection.chosen.has(key)));
    filters.append(menu);
  }
  const closeOthers = (kept) => {
    for (const menu of filters.querySelectorAll("details[open]")) if (menu !== kept) menu.open = false;
  };
  document.addEventListener("click", (event) => {
    if (!filters.contains(event.target)) closeOthers(null);
  });
  selection.followers.push(showChosen);
}

function showChosen() {
  const chips = [];
  for (const [key, values] of selection.chosen) {
    for (const value of values) {
      const text = `${columns.get(key).label} ${textOf(value)}`;
      const off = () => selection.toggle(key, value);
      chips.push(make("button", { type: "button", class: "chip", "aria-label": `Remove ${text}`, onclick: off }, text));
    }
  }
  const chosen = document.getElementById("chosen");
  const had = chosen.contains(document.activeElement);
  chosen.replaceChildren();
  if (chips.length > 0) {
    const clear = make("button", { type: "button", onclick: () => selection.clear() }, "Show all");
    chosen.append("Shown: ", ...chips, clear, " The words below charts are about all points.");
  }
  // Focus must not fall off the page with the button that had it.
  if (had) (chosen.querySelector("button") ?? document.querySelector("#filters summary")).focus();
}
