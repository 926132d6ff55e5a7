// SPDX-License-Identifier: Apache-2.0
// All gear contacts of a viewport: contact lines, contact patterns, gap indicators, forces of tooth pairs,
// and their legend.
import { button, choice, el, logSlider, tick } from "./dom.js";
import { Contact } from "./contacts.js";
import { alongPairs } from "./cones.js";
import { ContactLines } from "./contact_lines.js";
import { Gauge } from "./gauge.js";
import { SHADES } from "./flank_shades.js";
import { gradient } from "./load_colours.js";
import { length, number } from "./numbers.js";
import { Pattern } from "./pattern.js";

export class Flanks {
  /**
   * @param {any} scene
   * @param {import("three").Group} root group of the solids
   * @param {import("three").Group} over group drawn on top of the solids
   * @param {import("./poses.js").Poses} poses
   */
  constructor(scene, root, over, poses) {
    this.meshes = scene.contacts.map((each) => {
      const contact = new Contact(each, poses);
      return {
        contact,
        rods: new ContactLines(contact, over),
        pattern: new Pattern(contact, root, poses),
        gauge: new Gauge(contact, over),
        lines: [],
      };
    });
    this.greatest = Math.max(0, ...this.meshes.map(({ contact }) => contact.greatest));
    /** Quantity shown by the colours, a key of SHADES. */
    this.shade = "load";
    this.pressures = scene.contacts.some((contact) => contact.unit_pressure);
    this.showsLines = true;
    this.mode = "off";
    /** Whether the colour scale of each mesh ends at its own maximum. */
    this.own = false;
    /** Index of the mesh whose gap is shown, -1 none. */
    this.gauged = -1;
    this.hidden = false;
  }

  /** Whether anything is drawn on top of the solids. */
  get over() {
    return !this.hidden && this.meshes.length > 0 && (this.showsLines || this.gauged >= 0);
  }

  /** Arrows of the tooth pairs of all meshes, one per column of the force table. */
  pairs() {
    return this.meshes.flatMap((mesh) =>
      Array.from({ length: mesh.contact.pairs }, (_, slot) => {
        const size = this.#size(mesh.contact, slot);
        return {
          name: `${mesh.contact.name}, pair ${slot + 1}`,
          kind: "pair",
          unit: "N",
          size,
          now: () => mesh.forces?.[slot] ?? mesh.contact.pairForces([])[slot],
          largest: largest(mesh.contact.contact, size),
        };
      }),
    );
  }

  /** Maximum resultant force in a column of the force table [N]. */
  #size(contact, slot) {
    let most = 0;
    for (const { forces } of contact.contact.flanks)
      for (let k = slot; forces && k < forces.data.length; k += forces.width)
        most = Math.max(most, Math.abs(forces.data[k]));
    return most / Math.cos(contact.contact.base_helix);
  }

  /** Compute contact lines and pair forces; must precede the update of the arrows. */
  look() {
    for (const mesh of this.meshes) {
      mesh.lines = mesh.contact.lines();
      mesh.forces = mesh.contact.pairForces(mesh.lines);
    }
  }

  /** Upper end of the colour scale, of one mesh or common to all. @param {Contact} contact */
  top(contact) {
    if (this.own) return SHADES[this.shade].greatest(contact);
    return this.shade === "load" ? this.greatest : (this.hardest ??= this.greatestPressure());
  }

  /** Maximum over all meshes [Pa]. */
  greatestPressure() {
    return Math.max(0, ...this.meshes.map(({ contact }) => SHADES.pressure.greatest(contact)));
  }

  /**
   * Quantity shown by the colours at a station of a contact line.
   * @param {Contact} contact
   * @param {import("./contacts.js").Line} line
   * @param {number} s
   */
  value(contact, { ends, loads }, s) {
    const share = s / (loads.length - 1);
    const at = [0, 1].map((k) => ends[0][k] + (ends[1][k] - ends[0][k]) * share);
    return SHADES[this.shade].of(contact.contact, at, loads[s]);
  }

  /**
   * @param {number} visible size of a pixel in the scene [m]
   * @param {(point: import("three").Vector3) => boolean} removed by a section
   */
  update(visible, removed = () => false) {
    this.meshes.forEach(({ contact, rods, pattern, gauge, lines }, k) => {
      const greatest = this.top(contact);
      const shade = (line, s) => this.value(contact, line, s);
      rods.update(lines.filter(({ from }) => !removed(from)), this.showsLines && !this.hidden, visible, greatest, shade);
      pattern.update(contact.greatest > 0 ? this.mode : "off", this.hidden, greatest, SHADES[this.shade]);
      gauge.update(k === this.gauged && !this.hidden);
    });
  }

  /** @param {import("three").Plane[]} planes */
  cut(planes) {
    for (const { pattern } of this.meshes) pattern.cut(planes);
  }

  /** State for tests and for pages that control the viewer. */
  state() {
    const triple = (v) => [v.x, v.y, v.z];
    return {
      lines: this.showsLines,
      pattern: this.mode,
      gauge: this.gauged,
      greatest: this.greatest,
      shade: this.shade,
      greatestPressure: this.pressures ? this.greatestPressure() : null,
      meshes: this.meshes.map(({ contact, lines, pattern, gauge }) => ({
        name: contact.name,
        penetration: contact.penetration(),
        magnified: gauge.times,
        plates: gauge.shown(),
        lines: lines.map(({ pair, side, force, from, to, loads, ends }) => ({
          pair,
          side,
          force,
          from: triple(from),
          to: triple(to),
          loads: [...loads],
          values: Array.from(loads, (_, s) => this.value(contact, { ends, loads }, s)),
        })),
        pattern: this.mode === "off" ? [] : pattern.words(),
      })),
    };
  }
}

/** Maximum length of each component of a pair force. @param {any} contact @param {number} size */
function largest(contact, size) {
  const base = size * Math.cos(contact.base_helix);
  const alpha = contact.pressure_angle.data[0];
  if (contact.cone) {
    const parts = alongPairs(contact.cone, alpha, Math.tan(contact.base_helix), base, 0);
    return Object.fromEntries(Object.entries(parts).map(([part, vector]) => [part, vector.length()]));
  }
  return {
    circumferential: base * Math.cos(alpha),
    radial: base * Math.sin(alpha),
    axial: base * Math.abs(Math.tan(contact.base_helix)),
  };
}

/** Legend of the flank colours and of the magnified gap. */
export class FlankBox {
  /** @param {Flanks} flanks */
  constructor(flanks) {
    this.flanks = flanks;
    this.now = el("span", {});
    this.end = el("span", {});
    this.gap = el("div", { className: "ppv-gap" });
    this.bar = el(
      "div",
      { hidden: !(flanks.greatest > 0) },
      (this.what = el("span", {})),
      el("i", { style: `background:${gradient()}` }),
      el("div", { className: "ppv-ends" }, el("span", {}, "0"), this.now, this.end),
    );
    this.element = el("div", { className: "ppv-flanks", role: "status" }, this.bar, this.gap);
  }

  update() {
    const { flanks } = this;
    const gauge = flanks.meshes[flanks.gauged];
    // A mesh law without loads per tooth pair gives only the gap.
    const loads = flanks.greatest > 0 && (flanks.showsLines || flanks.mode !== "off");
    this.element.hidden = flanks.hidden || !(loads || gauge);
    if (this.element.hidden) return;
    const { legend, format } = SHADES[flanks.shade];
    let most = 0;
    for (const { contact, lines } of flanks.meshes)
      for (const line of lines) line.loads.forEach((_, s) => (most = Math.max(most, flanks.value(contact, line, s))));
    this.what.textContent = legend;
    this.now.textContent = most > 0 ? `current ${format(most)}` : "no load now";
    this.end.textContent = flanks.own ? "mesh maximum" : format(flanks.top(flanks.meshes[0].contact));
    this.gap.hidden = !gauge;
    if (!gauge) return;
    const both = gauge.contact.penetration();
    const words = (side, name) =>
      `${name} ${both[side] > 0 ? "penetration" : "gap"} ${length3(Math.abs(both[side]))}`;
    this.gap.textContent = `${gauge.contact.name}: ${words(1, "front flank")}, ${words(-1, "back flank")}; magnification × ${number(gauge.gauge.times, 2)}`;
  }
}

/** A length with three significant digits. @param {number} metres */
function length3(metres) {
  const [unit, name] = metres < 1e-3 ? [1e-6, "µm"] : [1e-3, "mm"];
  return `${number(metres / unit, 3)}\u2009${name}`;
}

/**
 * Text with the active diameters of both gears of a mesh.
 * @param {import("./contacts.js").Contact} contact
 */
export function activeWords({ contact, name }) {
  const { cone, width } = contact;
  const gears = contact.flanks[0].surfaces.map(({ gear, points }) => {
    const [nz, nx] = points.shape;
    // The diameters of bevel gears increase along the face width; those at the mean cone distance are given.
    const row = cone ? (-width[0] / (width[1] - width[0])) * (nz - 1) : 0;
    const first = Math.min(Math.floor(row), nz - 2);
    const at = (j, k) => Math.hypot(points.data[3 * (j * nx + k)], points.data[3 * (j * nx + k) + 1]);
    const ends = [0, nx - 1].map((k) => 2e3 * (at(first, k) + (row - first) * (at(first + 1, k) - at(first, k))));
    const [least, most] = [Math.min(...ends), Math.max(...ends)].map((d) => d.toFixed(2));
    return `${gear} ${least} to ${most}`;
  });
  const where = cone ? " at mid-face" : "";
  return `${name}: active diameters ${gears.join(", ")} mm${where}.`;
}

/**
 * Apply a change to the flanks of all viewports.
 * @param {import("./page.js").Page} page
 * @param {(flanks: Flanks) => void} change
 */
export function changeFlanks(page, change) {
  for (const { flanks } of page.stage.pictures) change(flanks);
  const { showsLines, mode, shade } = page.stage.pictures[0].flanks;
  // Results that are compared have common scales of arrows and colours.
  const hardest = shade === "load" ? 0 : Math.max(...page.stage.pictures.map(({ flanks }) => flanks.greatestPressure()));
  for (const { flanks } of page.stage.pictures) flanks.hardest = hardest || undefined;
  if (page.flankRows) {
    if (page.flankRows.shade) page.flankRows.shade.select.value = shade;
    page.flankRows.lines.input.checked = showsLines;
    page.flankRows.pattern.select.value = mode;
  }
  page.changed();
}

/**
 * Show the magnified gap of a mesh.
 * @param {import("./page.js").Page} page
 * @param {number} mesh -1 none
 * @param {number} times magnification; a suitable one if omitted
 */
export function showGauge(page, mesh, times) {
  const chosen = page.stage.pictures[0].flanks.meshes[mesh];
  const factor = times ?? chosen?.gauge.fitting() ?? 1;
  changeFlanks(page, (flanks) => {
    // The other result may have different meshes: they are matched by name.
    flanks.gauged = flanks.meshes.findIndex(({ contact }) => contact.name === chosen?.contact.name);
    for (const { gauge } of flanks.meshes) gauge.times = factor;
  });
  if (!page.flankRows) return;
  page.flankRows.times.set(factor);
  page.flankRows.describe(mesh);
  page.flankRows.gauge.select.value = String(mesh);
}

/**
 * View along the axis on the mesh whose gap is shown, or on the first mesh.
 * @param {import("./page.js").Page} page
 */
function lookAtGap(page) {
  const { flanks, data } = page.stage.pictures[0];
  if (flanks.gauged < 0) showGauge(page, 0);
  const name = flanks.meshes[flanks.gauged]?.contact.name;
  const arrow = data.arrows.find((each) => each.kind === "mesh" && each.name === name);
  if (arrow) page.intoMesh(arrow);
}

/** Rows of the panel "Flanks". @param {import("./page.js").Page} page */
export function flankRows(page) {
  const { meshes, greatest, pressures } = page.stage.pictures[0].flanks;
  const set = (change) => changeFlanks(page, change);
  const lines = tick("contact lines", true, (on) => set((flanks) => (flanks.showsLines = on)));
  const pattern = choice(
    "contact pattern",
    [
      ["off", "none"],
      ["all", "all teeth superimposed"],
      ["each", "each tooth"],
    ],
    (mode) => set((flanks) => (flanks.mode = mode)),
    "Maximum load or pressure up to the current time at every point of a flank",
  );
  const shade = pressures
    ? choice(
        "colour by",
        Object.entries(SHADES).map(([key, { name }]) => [key, name]),
        (what) => set((flanks) => (flanks.shade = what)),
        "Load per width, or maximum Hertzian pressure of the line contact",
      )
    : null;
  const times = logSlider({
    label: "magnification ×",
    title: "Magnification of the gap along the line of action",
    least: 1,
    most: 1e4,
    value: 1,
    show: (x) => number(x, 2),
    changed: (x) => set((flanks) => flanks.meshes.forEach(({ gauge }) => (gauge.times = x))),
  });
  const gauge = choice(
    "show gap of",
    [["-1", "none"], ...meshes.map(({ contact }, k) => [String(k), contact.name])],
    (k) => showGauge(page, Number(k)),
    "Mesh with a magnified gap",
  );
  const own = tick("separate colour scale per mesh", false, (on) => set((flanks) => (flanks.own = on)));
  const active = el("p", { className: "ppv-soft" });
  page.flankRows = {
    lines,
    pattern,
    shade,
    gauge,
    times,
    /** @param {number} k index of the mesh whose gap is shown */
    describe(k) {
      const mesh = meshes[k] ?? (meshes.length === 1 ? meshes[0] : null);
      active.hidden = !mesh;
      if (mesh) active.textContent = activeWords(mesh.contact);
    },
  };
  page.flankRows.describe(-1);
  return [
    lines.row,
    greatest > 0 ? pattern.row : null,
    greatest > 0 && shade ? shade.row : null,
    greatest > 0 && meshes.length > 1 ? own.row : null,
    gauge.row,
    active,
    times.row,
    el(
      "div",
      { className: "ppv-buttons" },
      button("view gap", "View along the axis on the magnified gap", () => lookAtGap(page)),
    ),
    el(
      "p",
      { className: "ppv-soft" },
      greatest > 0
        ? "Spheres at the ends of a line show the flank (yellow: front, purple: back); thin grey lines carry no load."
        : "Yellow lines: front flanks; purple: back flanks; thin and grey: no contact. The mesh law gives no loads per tooth pair.",
    ),
  ].filter(Boolean);
}
