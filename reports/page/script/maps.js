// Heat maps: one frame at a time, a slider over tile sizes, a picture for each mode and kind.

function distinct(list) {
  return [...new Set(list)];
}

function showMaps() {
  const root = document.getElementById("maps");
  if (!root) return;
  const maps = data.maps.list;
  const frames = distinct(maps.map((map) => map.frame));
  const tiles = distinct(maps.map((map) => map.tile)).sort((a, b) => a - b);
  let frame = frames[0];
  let tile = tiles.includes(8) ? 8 : tiles[0];

  const buttons = frames.map((name) =>
    make("button", { type: "button", onclick: () => ((frame = name), show()) }, name));
  const shown = make("output", { for: "tile-slider" });
  const slider = make("input", {
    id: "tile-slider", type: "range", min: 0, max: tiles.length - 1, step: 1, value: tiles.indexOf(tile),
    oninput: () => ((tile = tiles[slider.value]), show()),
  });
  if (frames.length > 1) {
    root.append(make("div", { class: "tools", role: "group", "aria-label": "Frame" }, ...buttons));
  }
  if (tiles.length > 1) {
    root.append(make("div", { class: "tools" }, make("label", { for: "tile-slider" }, "Tile size"), slider, shown));
  }
  const pictures = distinct(maps.map((map) => `${map.kind}|${map.mode}`)).sort().reverse().map((which) => {
    const [kind, mode] = which.split("|");
    const picture = { kind, mode, image: make("img", {}), words: make("span"), scale: make("span") };
    const bar = make("div", { class: "scale", "aria-hidden": "true" }, "0", make("i"), picture.scale);
    const title = make("strong", {}, `${kind}, ${mode}`);
    const caption = make("figcaption", {}, title, " ", picture.words);
    picture.figure = make("figure", {}, caption, picture.image, bar);
    return picture;
  });
  const view = make("img", { class: "view" });
  const viewFigure = make("figure", { class: "view-figure" }, make("figcaption", {}, make("strong", {}, "The frame")), view);
  const grid = make("div", { class: "maps" }, viewFigure, ...pictures.map((picture) => picture.figure));
  root.append(grid);

  function show() {
    buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(frames[i] === frame)));
    slider.value = tiles.indexOf(tile);
    slider.setAttribute("aria-valuetext", `${tile} by ${tile} pixels`);
    shown.textContent = `${tile} × ${tile}`;
    viewFigure.hidden = !(frame in data.maps.frames);
    grid.classList.toggle("with-view", !viewFigure.hidden);
    if (!viewFigure.hidden) {
      view.src = `data:image/png;base64,${data.maps.frames[frame]}`;
      view.alt = `The frame ${frame}, shaded.`;
    }
    for (const picture of pictures) {
      const map = maps.find((m) => m.frame === frame && m.tile === tile && m.kind === picture.kind && m.mode === picture.mode);
      picture.figure.hidden = !map;
      if (!map) continue;
      picture.image.src = `data:image/png;base64,${data.maps.images[map.image]}`;
      picture.image.alt = `Heat map of the ${map.kind} of ${frame}, ${map.mode}, tile ${tile}: ` +
        `${textOf(map.total)} in all; white is ${textOf(map.maximum)} at a pixel.`;
      picture.scale.textContent = `${textOf(map.maximum)} at a pixel`;
      picture.words.replaceChildren(`${textOf(map.total)} words. `);
      if (map.file) {
        const href = map.file.split("/").map(encodeURIComponent).join("/");
        picture.words.append(make("a", { href }, "Full size"));
      }
    }
  }

  // One tile, or one scene, chosen elsewhere is shown here.
  selection.followers.push(() => {
    const only = (key) => (selection.chosen.get(key)?.size === 1 ? [...selection.chosen.get(key)][0] : null);
    const wanted = only("block.tile");
    if (tiles.includes(wanted)) tile = wanted;
    const scene = only("scene");
    const found = frames.find((name) => name === scene || sceneOf(name) === scene);
    if (scene !== null && found) frame = found;
    show();
  });
  show();
}

function sceneOf(label) {
  for (let point = 0; point < data.points; ++point) {
    if (valueAt("frame_label", point) === label) return valueAt("scene", point);
  }
  return null;
}
