// SPDX-License-Identifier: Apache-2.0
// Table of the current forces in the colours of the arrows.
import { FORCES, STATES } from "./colours.js";
import { button, el } from "./dom.js";
import { force } from "./numbers.js";

/** Maximum fraction of the width, and of the height, of the scene that the legend may cover. */
const MOST = 0.48;
/** Fraction of the width above which the height limit applies. */
const TALL = 0.32;

export class Legend {
  /** @param {any[]} arrows of a scene */
  constructor(arrows) {
    this.sizes = sizesOf(arrows);
    this.columns = FORCES.filter((part) =>
      arrows.some((arrow) => (arrow.components ?? arrow.largest)?.[part]),
    );
    this.rows = arrows.map((arrow) => {
      const state = arrow.state ? el("span", { className: "ppv-state" }) : null;
      const cells = this.columns.map((part) => el("td", { className: `ppv-${part}` }));
      const { name } = arrow;
      return {
        state,
        cells,
        announced: null,
        row: el("tr", {}, el("th", { scope: "row", title: `${arrow.kind} ${name}` }, state, name), ...cells),
      };
    });
    this.folder = button("forces", "Collapse or expand the forces", () => this.fold(!this.folded), {
      "aria-expanded": "true",
    });
    this.folded = this.chosen = false;
    const head = el(
      "tr",
      {},
      el("td", {}, this.folder),
      ...this.columns.map((part) => el("th", { scope: "col", className: `ppv-${part}` }, el("i"), part)),
    );
    this.states = el("div", { className: "ppv-states" });
    this.seen = new Set();
    for (const arrow of arrows) for (const state of arrow.state?.data ?? []) this.seen.add(state === 255 ? -1 : state);
    this.#explain();
    this.element = el(
      "div",
      { className: "ppv-legend", tabindex: "0", role: "region", "aria-label": "Current forces" },
      el("table", {}, el("thead", {}, head), el("tbody", {}, ...this.rows.map(({ row }) => row))),
      this.states,
    );
    this.element.hidden = !arrows.length;
  }

  /** Words and colours of the contact states that occur. */
  #explain() {
    this.states.replaceChildren(
      ...[1, -1, 2, 0]
        .filter((state) => this.seen.has(state))
        .map((state) => el("span", {}, el("i", { style: `background:${STATES[state].colour}` }), STATES[state].word)),
    );
  }

  /**
   * @param {boolean} on
   * @param {boolean} chosen by the user; a change of size then no longer folds or unfolds the legend
   */
  fold(on, chosen = true) {
    this.chosen ||= chosen;
    this.folded = on;
    this.element.classList.toggle("ppv-folded", on);
    this.folder.setAttribute("aria-expanded", String(!on));
  }

  /** Fold the legend if it would cover too much of the scene. */
  settle() {
    if (this.chosen || this.element.hidden) return;
    this.fold(false, false);
    const { clientWidth: width, clientHeight: height } = this.element.parentElement;
    const { offsetWidth: wide, offsetHeight: high } = this.element;
    const cut = this.element.scrollHeight > this.element.clientHeight + 1;
    this.fold(cut || wide > MOST * width || (wide > TALL * width && high > MOST * height), false);
  }

  /** Fraction of the width covered at the right; zero if the rest would be too narrow. */
  get share() {
    if (this.element.hidden || this.folded) return 0;
    const share = (this.element.offsetWidth + 12) / Math.max(this.element.parentElement.clientWidth, 1);
    return share > MOST ? 0 : share;
  }

  /** Fraction of the width covered by the header of the folded legend. */
  get strip() {
    if (this.element.hidden || !this.folded) return 0;
    return (this.element.offsetWidth + 12) / Math.max(this.element.parentElement.clientWidth, 1);
  }

  /** Fraction of the height covered at the top. */
  get drop() {
    return (this.element.offsetHeight + 12) / Math.max(this.element.parentElement.clientHeight, 1);
  }

  /**
   * @param {import("./arrows.js").Force[]} forces
   * @param {Set<string>} shown kinds
   * @param {boolean} hidden
   */
  update(forces, shown, hidden) {
    this.element.hidden = hidden || !forces.some((each) => shown.has(each.kind));
    if (this.element.hidden) return;
    forces.forEach((each, k) => {
      const { row, cells, state } = this.rows[k];
      // Tooth pairs out of mesh are not listed.
      row.hidden = !shown.has(each.kind) || (each.kind === "pair" && !each.total);
      if (row.hidden) return;
      this.columns.forEach((part, c) => {
        const text =
          part in each.values
            ? this.#words(each.values[part], each.unit)
            : "";
        if (cells[c].textContent !== text) cells[c].textContent = text;
      });
      if (state && this.rows[k].announced !== each.state) {
        // a model that runs in the page may reach states that it did not start with
        if (each.state in STATES && !this.seen.has(each.state)) {
          this.seen.add(each.state);
          this.#explain();
        }
        const { word, colour } = STATES[each.state] ?? STATES[0];
        this.rows[k].announced = each.state;
        state.style.background = colour;
        state.title = word;
        state.setAttribute("aria-label", word);
      }
    });
  }

  /**
   * A force with the unit prefix common to all forces of this unit.
   * @param {number} value
   * @param {string} unit
   */
  #words(value, unit) {
    const { most, least } = this.sizes[unit] ?? {};
    return force(value, unit, most || value, least || value);
  }

  /** Rows for a saved picture. @param {import("./arrows.js").Force[]} forces @param {Set<string>} shown */
  lines(forces, shown) {
    return forces
      .filter((each) => shown.has(each.kind) && (each.kind !== "pair" || each.total))
      .map((each) => ({
        name: each.name,
        values: this.columns
          .filter((part) => part in each.values)
          .map((part) => ({ part, text: this.#words(each.values[part], each.unit) })),
      }));
  }
}

/**
 * Minimum and maximum size of the arrows of each unit; arrows without force are ignored.
 * @param {any[]} arrows
 */
function sizesOf(arrows) {
  const sizes = {};
  for (const { unit = "N", size } of arrows) {
    if (!size) continue;
    const known = (sizes[unit] ??= { most: size, least: size });
    known.most = Math.max(known.most, size);
    known.least = Math.min(known.least, size);
  }
  return sizes;
}
