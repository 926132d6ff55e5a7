// SPDX-License-Identifier: Apache-2.0
// The toolbar and its panels. One panel is open at a time, over a corner of the scene.
import { button, choice, el, logSlider, tick } from "./dom.js";
import { addressOf } from "./link.js";
import { number } from "./numbers.js";
import { download, fileName, film, movingSolids, png, stl } from "./save.js";

/** Maximum fraction of the width that the fitted view leaves to a panel. */
const MOST = 0.4;

export class Panels {
  constructor() {
    this.bar = el("div", { className: "ppv-tools", role: "toolbar", "aria-label": "Scene" });
    this.panel = el("div", { className: "ppv-panel", hidden: true });
    this.open = null;
    this.panel.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.close();
    });
  }

  /** @param {string} text @param {string} title @param {() => void} onclick */
  action(text, title, onclick) {
    const made = button(text, title, onclick);
    this.bar.append(made);
    return made;
  }

  /** @param {string} text @param {string} title @param {Node[]} rows */
  add(text, title, rows) {
    const made = button(
      text,
      title,
      () => (this.open === text ? this.close() : this.show(text, rows, made)),
      { "aria-expanded": "false" },
    );
    this.bar.append(made);
    return made;
  }

  show(text, rows, opener) {
    this.close();
    this.open = text;
    this.opener = opener;
    opener.setAttribute("aria-expanded", "true");
    this.panel.replaceChildren(
      el(
        "div",
        { className: "ppv-panel-head" },
        el("b", {}, text),
        button("×", "Close", () => this.close()),
      ),
      ...rows,
    );
    this.panel.hidden = false;
  }

  /** Fraction of the width covered by an open panel; zero if the rest would be too narrow. */
  get share() {
    const share = this.open ? (this.panel.offsetWidth + 12) / Math.max(this.panel.parentElement.clientWidth, 1) : 0;
    return share > MOST ? 0 : share;
  }

  close() {
    if (!this.open) return;
    const inside = this.panel.contains(document.activeElement);
    this.open = null;
    this.panel.hidden = true;
    this.opener.setAttribute("aria-expanded", "false");
    if (inside) this.opener.focus();
  }
}

/** Rows of the panel "View". @param {import("./page.js").Page} page */
export function viewRows(page) {
  const { stage } = page;
  const views = [
    ["axis", "Along the axis of the shafts (a)"],
    ["side", "From the side (e)"],
    ["top", "From above (t)"],
    ["iso", "Oblique (i)"],
  ];
  page.parallel = tick("parallel projection (o)", false, (on) => page.project(on));
  page.followed = choice(
    "follow",
    [["-1", "none"], ...page.views.names.map((name, k) => [String(k), name])],
    (value) => page.follow(Number(value)),
    "Body that the camera follows (1 to 9, 0)",
  );
  const turning = tick("rotate with body", false, (on) => {
    page.views.turning = on;
    page.views.follow(page.views.body, on);
  });
  const solids = page.scenes.flatMap((scene) => scene.solids);
  const covers = solids.some((solid) => solid.see_through)
    ? choice(
        "housing",
        [
          ["see-through", "see-through"],
          ["solid", "solid"],
          ["hidden", "hidden"],
        ],
        (how) => {
          for (const picture of stage.pictures) picture.solids.cover(how);
          page.changed();
        },
      ).row
    : null;
  const schematics = solids.some((solid) => solid.schematic)
    ? tick("schematic parts", true, (on) => {
        for (const picture of stage.pictures) picture.solids.schematics(on);
        page.changed();
      }).row
    : null;
  const meshes = page.scenes
    .flatMap((scene) => scene.arrows.filter((arrow) => arrow.kind === "mesh"))
    .filter((arrow, k, all) => all.findIndex(({ name }) => name === arrow.name) === k);
  const looks = meshes.map((arrow) =>
    button(arrow.name, `View the mesh ${arrow.name} along its axis`, () =>
      page.intoMesh(arrow),
    ),
  );
  return [
    el(
      "div",
      { className: "ppv-buttons" },
      ...views.map(([name, title]) => button(name, title, () => page.views.named(name))),
    ),
    page.followed.row,
    turning.row,
    page.parallel.row,
    covers,
    schematics,
    looks.length
      ? el(
          "div",
          {},
          el("span", { className: "ppv-soft" }, "view a mesh"),
          el("div", { className: "ppv-buttons" }, ...looks),
        )
      : null,
  ].filter(Boolean);
}

const NAMES = {
  mesh: "mesh forces",
  pair: "forces of tooth pairs",
  bearing: "bearing forces",
  load: "loads",
};

/** Rows of the panel "Forces". @param {import("./page.js").Page} page */
export function forceRows(page) {
  const all = page.stage.pictures.map((picture) => picture.arrows);
  const kinds = [...new Set(all.flatMap((arrows) => [...arrows.kinds]))];
  const scale = logSlider({
    label: "length",
    title: "Length of the arrows",
    least: 0.05,
    most: 20,
    value: 1,
    show: (x) => `× ${number(x, 2)}`,
    changed: (x) => {
      for (const arrows of all) arrows.scale = x;
      page.changed();
    },
  });
  page.kinds = Object.fromEntries(
    kinds.map((kind) => [
      kind,
      tick(NAMES[kind] ?? kind, all.some((arrows) => arrows.shown.has(kind)), (on) => page.arrows(kind, on)),
    ]),
  );
  page.sparse = tick("sparse", true, (on) => page.density(on));
  page.sparse.row.title = "Omit small components and arrows close to larger ones; smaller arrows where there are many";
  const many = all.some((arrows) => arrows.many);
  return [...Object.values(page.kinds).map(({ row }) => row), many ? page.sparse.row : null, scale.row].filter(Boolean);
}

/** Copy a text, which is also the new address of the page. @param {string} text @returns {Promise<string>} */
async function copied(text) {
  history.replaceState(null, "", text);
  try {
    await navigator.clipboard.writeText(text);
    return "link copied";
  } catch {
    return "the link is in the address bar";
  }
}

/** Rows of the panel "Save". @param {import("./page.js").Page} page */
export function saveRows(page) {
  const { stage } = page;
  const picture = (times) => download(png(page, times), fileName(page, "png"));
  const camera = film(stage.canvas);
  let stop = null;
  const relabel = (text, title) => {
    record.textContent = text;
    record.title = record.ariaLabel = title;
    record.setAttribute("aria-pressed", String(Boolean(stop)));
  };
  const offer = camera && `Record a video of the playback up to the end of the record, ${camera.ending}`;
  const record = camera
    ? button("video", offer, async () => {
        if (!stop) {
          page.filming = true;
          stage.coarsen(false);
          stop = camera.start();
          relabel("stop and save", "Stop and save the video; it stops automatically at the end of the playback");
          page.player.atEnd = () => record.click();
          page.toggle(true);
          return;
        }
        const end = stop;
        stop = null;
        page.player.atEnd = null;
        page.filming = false;
        page.toggle(false);
        relabel("video", offer);
        download(await end(), fileName(page, camera.ending));
      })
    : null;
  return [
    el(
      "div",
      { className: "ppv-buttons" },
      button("picture", "PNG of the scene with title, time and forces", () => picture(1)),
      button("picture × 2", "PNG with twice the resolution", () => picture(2)),
      record,
    ),
    /^(file|https?):/.test(location.protocol)
      ? el(
          "div",
          { className: "ppv-buttons" },
          button("copy link", "Copy the address of this page with view, section and time", async () =>
            page.hint(await copied(addressOf(page))),
          ),
        )
      : null,
    el(
      "div",
      { className: "ppv-buttons" },
      button("GLB (animated)", "Solids and their motion, binary glTF", () =>
        download(movingSolids(page), fileName(page, "glb")),
      ),
      button("STL", "Solids at the current time, in metres", () => download(stl(page), fileName(page, "stl"))),
    ),
  ].filter(Boolean);
}

/** Rows of the panel "Vibration". @param {import("./page.js").Page} page */
export function vibrationRows(page) {
  page.magnification = logSlider({
    label: "magnification ×",
    title: "Magnification of vibrations; rotation is not magnified (m)",
    least: 1,
    most: 1e4,
    value: 1,
    show: (x) => String(x < 10 ? Number(x.toPrecision(2)) : Math.round(x)),
    changed: (x) => page.magnify(x),
  });
  return [
    page.magnification.row,
    el(
      "p",
      { className: "ppv-soft" },
      "Displacements, tilts and torsion about their means; mean rotation is not magnified.",
    ),
  ];
}
