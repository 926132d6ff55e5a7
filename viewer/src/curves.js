// SPDX-License-Identifier: Apache-2.0
// The panel below the scene: plots of channels selected from a searchable list, and spectra.
import { button, el } from "./dom.js";
import { withGroups } from "./groups.js";
import { Plots } from "./plots.js";
import { Spectra } from "./spectra.js";

export class Curves {
  /** @param {any[]} scenes @param {number[]} range @param {any[]} marks @param {(t: number) => void} seek */
  constructor(scenes, range, marks, seek) {
    const channels = scenes.map((scene) => withGroups(scene.channels));
    const ends = scenes.map((scene) => scene.times?.data.at(-1));
    this.plots = new Plots(channels, marks, range, seek, ends);
    this.spectra = new Spectra(scenes, channels, seek);
    this.labels = new Map(channels.flat().map((channel) => [channel.name, channel.label ?? channel.name]));
    /** Members of each group of channels, and groups whose members are listed. */
    this.members = new Map(channels.flat().filter((channel) => channel.members).map(({ name, members }) => [name, members]));
    this.whole = new Map([...this.members].flatMap(([name, members]) => members.map((member) => [member, name])));
    this.unfolded = new Set();
    this.search = el("input", {
      type: "search",
      placeholder: `add a curve (${this.labels.size - this.whole.size})`,
      "aria-label": "Search channels",
      title: "Search channels by words of their names",
    });
    this.list = el("div", { className: "ppv-list", role: "listbox", "aria-label": "Channels", hidden: true });
    this.search.addEventListener("focus", () => this.fill());
    this.search.addEventListener("input", () => this.fill());
    this.search.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.close();
      if (event.key === "Enter" || event.key === "ArrowDown") {
        const first = this.list.querySelector("button");
        if (event.key === "Enter") first?.click();
        else first?.focus();
        event.preventDefault();
      }
      event.stopPropagation();
    });
    this.list.addEventListener("keydown", (event) => {
      const way = { ArrowDown: "nextElementSibling", ArrowUp: "previousElementSibling" }[event.key];
      if (way) (document.activeElement?.[way] ?? this.search).focus();
      if (event.key === "Escape") this.close();
      if (way || event.key === "Escape") event.preventDefault();
      event.stopPropagation();
    });
    this.picker = el("div", { className: "ppv-picker" }, this.search, this.list);
    this.picker.addEventListener("focusout", (event) => {
      if (!this.picker.contains(event.relatedTarget)) this.close();
    });
    this.tab = button("Spectrum", "Switch between time curves and spectrum", () => this.turn());
    this.tab.hidden = !this.spectra.names.length;
    this.plots.onRemove = () => this.list.hidden || this.fill();
    this.body = el("div", { className: "ppv-curves-body" }, this.plots.element, this.plots.more, this.spectra.element);
    this.element = el(
      "div",
      { className: "ppv-curves" },
      this.body,
    );
    /** Shown with the time controls. */
    this.bar = el("div", { className: "ppv-bar" }, this.picker, this.tab);
    this.plots.needs = (height) => (this.element.style.minHeight = `${height}px`);
    this.bar.hidden = this.element.hidden = !this.labels.size && !this.spectra.names.length;
  }

  /** Channels that contain all words of the search text. */
  matches() {
    const wanted = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    return [...this.labels].filter(([name, label]) => {
      const whole = this.whole.get(name);
      if (whole && !this.unfolded.has(whole) && !this.plots.names.has(name)) return false;
      const text = `${name} ${label}`.toLowerCase();
      return wanted.every((word) => text.includes(word));
    });
  }

  fill() {
    const all = this.matches();
    this.list.replaceChildren(...all.slice(0, 200).flatMap(([name, label]) => this.#entry(name, label)));
    if (!all.length) this.list.append(el("p", {}, "No matching channel."));
    if (all.length > 200)
      this.list.append(el("p", {}, `${all.length - 200} more: refine the search.`));
    this.list.hidden = false;
  }

  /** Entry of the list; a group is followed by a button that lists its members. */
  #entry(name, label) {
    const member = this.whole.has(name);
    const option = el(
      "button",
      {
        type: "button",
        role: "option",
        className: member ? "ppv-member" : "",
        "aria-selected": String(this.plots.names.has(name)),
        title: name,
        onclick: (event) => {
          this.plots.show(name, !this.plots.names.has(name));
          event.currentTarget.setAttribute("aria-selected", String(this.plots.names.has(name)));
        },
      },
      label,
    );
    const members = this.members.get(name);
    if (!members) return [option];
    const open = this.unfolded.has(name);
    const unfold = el(
      "button",
      {
        type: "button",
        className: "ppv-unfold",
        "aria-expanded": String(open),
        onclick: () => {
          open ? this.unfolded.delete(name) : this.unfolded.add(name);
          this.fill();
          const again = [...this.list.querySelectorAll(".ppv-unfold")].find(({ dataset }) => dataset.group === name);
          again?.focus();
        },
      },
      `${open ? "▾" : "▸"} ${members.length} planets`,
    );
    unfold.dataset.group = name;
    unfold.setAttribute("aria-label", `List the planets of ${label}`);
    return [option, unfold];
  }

  close() {
    this.list.hidden = true;
  }

  /** @param {string} channel @param {string} [over] */
  spectrum(channel, over) {
    if (!this.spectra.names.includes(channel)) return;
    if (this.spectra.element.hidden) this.turn();
    this.spectra.choose(channel, over);
  }

  turn() {
    if (!this.spectra.names.length) return;
    const spectra = this.spectra.element.hidden;
    this.spectra.element.hidden = !spectra;
    this.plots.element.hidden = spectra;
    this.plots.more.hidden = true;
    this.tab.textContent = spectra ? "Curves" : "Spectrum";
    this.picker.style.visibility = spectra ? "hidden" : "";
    if (spectra) this.spectra.build();
    else this.resize();
  }

  /** @param {number} t */
  cursor(t) {
    this.plots.cursor(t);
    this.spectra.cursor(t);
  }

  build() {
    if (this.element.hidden) return;
    this.plots.build();
    if (!this.spectra.element.hidden) this.spectra.build();
  }

  resize() {
    if (this.element.hidden) return;
    if (!this.plots.element.hidden) this.plots.resize();
    this.spectra.resize();
  }
}
