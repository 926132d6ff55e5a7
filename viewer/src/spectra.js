// SPDX-License-Identifier: Apache-2.0
// Amplitude spectra over frequency or order, of the whole record and around the cursor, for scenes that
// contain them.
import uPlot from "uplot";
import { choice, el } from "./dom.js";
import { colourOfChannel } from "./colours.js";
import { number, within } from "./numbers.js";
import { labels, secondTint } from "./plots.js";
import { Waterfall, amplitudeOf, frequencyUnit, nearest } from "./waterfall.js";

const OVER_TIME = " and time";
/** Colour of the spectrum around the cursor. */
const NEAR = "#d2484f";

/**
 * Round down to one digit: a logarithmic axis that starts at 9.7 would have no tick at 10.
 * @param {number} x
 */
const oneDigit = (x) => {
  const power = Math.floor(Math.log10(x));
  return Number(`${Math.max(1, Math.floor(x / 10 ** power))}e${power}`);
};

/**
 * Indices of isolated values, with a gap on both sides. Rows of other series are undefined.
 * @param {(number|null|undefined)[]} column
 */
const alone = (column) =>
  column.flatMap((value, k) => (value != null && column[k - 1] === null && column[k + 1] === null ? [k] : []));

/**
 * Spacing of the spectral lines of the record; the file may contain only some of the lines.
 * @param {any} spectrum
 */
const resolution = ({ resolution: given, lines }) =>
  given ?? lines.data.reduce((least, x, k) => (k ? Math.min(least, x - lines.data[k - 1]) : least), lines.data[0]);

export class Spectra {
  /**
   * @param {any[]} scenes of each result
   * @param {any[][]} channels of each result, for their labels
   * @param {(t: number) => void} seek
   */
  constructor(scenes, channels, seek) {
    this.spectra = scenes.map((scene) => scene.spectra);
    this.maps = scenes.map((scene) => scene.maps);
    this.names = [...new Set(this.spectra.flat().map((spectrum) => spectrum.channel))];
    const label = (name) => channels.flat().find((channel) => channel.name === name)?.label ?? name;
    this.channels = channels;
    this.name = this.names[0];
    this.time = scenes[0]?.times.data[0] ?? 0;
    this.box = el("div", { className: "ppv-box" });
    this.maps_box = el("div", { className: "ppv-maps", hidden: true });
    this.read = el("output", {});
    this.unit = el("small", { className: "ppv-soft" });
    this.waterfall = new Waterfall(this.maps_box, seek, (text) => (this.read.textContent = text));
    this.choice = choice(
      "spectrum of",
      this.names.map((name) => [name, label(name)]),
      (name) => this.choose(name, this.over),
    );
    this.ways = choice("over", [], (over) => this.choose(this.name, over));
    this.near = el("span", { className: "ppv-curve", hidden: true }, el("i", {}), el("span", {}, "at the cursor"));
    this.element = el(
      "div",
      { className: "ppv-spectra" },
      el("div", { className: "ppv-caption" }, this.choice.row, this.ways.row, this.unit, this.near, this.read),
      this.box,
      this.maps_box,
    );
    this.element.hidden = true;
  }

  /** Representations available for a channel, as text. @param {string} name */
  waysOf(name) {
    const word = ({ of }) => (of ? `orders of ${of}` : "frequency");
    const mine = (lists) => lists.flat().filter((found) => found.channel === name);
    return [
      ...new Set([
        ...mine(this.spectra).map(word),
        ...mine(this.maps).map((map) => word(map) + OVER_TIME),
      ]),
    ];
  }

  /**
   * @param {string} name of a channel
   * @param {string} [over] representation; a similar or the first one if it is not available
   */
  choose(name, over = "") {
    this.name = name;
    const ways = this.waysOf(name);
    // Orders of another shaft are the most similar representation.
    const alike = ways.find((way) => way.split(" ")[0] === over.split(" ")[0] && way.endsWith(OVER_TIME) === over.endsWith(OVER_TIME));
    this.over = ways.includes(over) ? over : (alike ?? ways[0]);
    this.ways.select.replaceChildren(...ways.map((way) => el("option", { value: way }, way)));
    this.ways.select.value = this.over;
    this.choice.select.value = name;
    this.build();
  }

  /** Spectrum or map of the selected channel and representation, at most one per result. */
  #found(lists) {
    const of = /^orders of (.*?)( and time)?$/.exec(this.over)?.[1] ?? "";
    return lists.map((list) => list.find((found) => found.channel === this.name && (found.of ?? "") === of));
  }

  /** Displayed unit of the selected channel, and the conversion factor. @param {any} found spectrum or map */
  #shown(found) {
    const unit = found?.unit ?? "1";
    const channel = this.channels.flat().find(({ name }) => name === this.name);
    if (!channel?.shown_unit || channel.unit !== unit) return { unit, scale: 1 };
    return { unit: channel.shown_unit, scale: channel.scale ?? 1 };
  }

  build() {
    if (!this.over) return this.choose(this.name);
    this.plot?.destroy();
    this.plot = null;
    this.waterfall.destroy();
    this.read.textContent = "";
    const style = getComputedStyle(this.element);
    const ink = (name, otherwise) => style.getPropertyValue(name).trim() || otherwise;
    const inks = { soft: ink("--v-soft", "#666"), grid: ink("--v-grid", "#ddd"), paper: ink("--v-paper", "#fff") };
    const map = this.over.endsWith(OVER_TIME);
    this.shown = this.#shown(this.#found(this.spectra).concat(this.#found(this.maps)).find(Boolean));
    const { unit } = this.shown;
    this.unit.textContent = unit === "1" ? "peak amplitude" : `peak amplitude in ${unit}`;
    if (map) this.unit.textContent = "colours: peak amplitude in dB re maximum";
    this.box.hidden = map;
    this.maps_box.hidden = !map;
    this.near.hidden = true;
    if (map) this.waterfall.build(this.#found(this.maps).filter(Boolean), inks, this.shown);
    else this.#plot(inks);
    this.resize();
    this.cursor(this.time);
  }

  #plot(inks) {
    const found = this.#found(this.spectra);
    const { unit, scale } = this.shown;
    const tables = found
      .filter(Boolean)
      .map(({ lines, amplitude }) => [
        Array.from(lines.data),
        Array.from(amplitude.data, (value) => (value > 0 ? value * scale : null)),
      ]);
    const axis = {
      stroke: inks.soft,
      grid: { stroke: inks.grid, width: 1 },
      ticks: { show: false },
      font: "11px system-ui, sans-serif",
    };
    const colour = colourOfChannel(this.element, this.name, 0);
    const { of = "" } = found.find(Boolean) ?? {};
    const line = { width: 1.2, points: { show: false }, spanGaps: true };
    const series = found.flatMap((spectrum, result) =>
      spectrum
        ? [{ ...line, stroke: result ? secondTint(this.element, colour) : colour, dash: result ? [6, 4] : undefined }]
        : [],
    );
    const most = tables.reduce((top, [, y]) => y.reduce((a, value) => Math.max(a, value ?? 0), top), 1e-300);
    const [per, hertz] = frequencyUnit(tables.map(([x]) => x.at(-1)));
    // The spectrum around the cursor is shown for the first result only.
    this.passing = this.#found(this.maps)[0];
    if (this.passing) {
      tables.push([Array.from(this.passing.lines.data), Array.from(this.passing.lines.data, () => null)]);
      // Amplitudes below the range of the map are gaps; a line between two gaps is drawn as a point.
      const points = { show: false, filter: (self, k) => alone(self.data[k]), size: 4, fill: NEAR, stroke: NEAR };
      series.push({ ...line, stroke: NEAR, width: 1, spanGaps: false, points });
      this.near.hidden = false;
      this.near.firstChild.style.background = NEAR;
    }
    // Frequency resolution; of two results the coarser one.
    const half = Math.max(...found.filter(Boolean).map(resolution)) / 2;
    const place = of ? (x) => `order ${within(x, half)}` : (x) => `${within(x * per, half * per)} ${hertz}`;
    this.plot = new uPlot(
      {
        width: 300,
        height: 160,
        padding: [6, 44, 0, 0],
        legend: { show: false },
        cursor: { points: { show: false }, y: false, drag: { x: true, y: false } },
        series: [{}, ...series],
        scales: {
          x: { time: false },
          // The axis is limited to five decades below the maximum.
          y: { distr: 3, range: (_, low) => [oneDigit(Math.max(low ?? 0, most * 1e-5)), most * 1.6] },
        },
        axes: [
          {
            ...axis,
            size: 22,
            gap: 3,
            values: (_, splits) => labels(of ? splits : splits.map((x) => x * per), of ? "order" : hertz),
          },
          {
            ...axis,
            size: 62,
            gap: 4,
            space: 28,
            values: (_, splits) => splits.map((x) => (x === null ? "" : number(x, 2))),
          },
        ],
        hooks: {
          setCursor: [
            (self) => {
              const k = self.cursor.idx;
              const values = k == null ? [] : self.data.slice(1).map((column) => column[k]);
              const read = values.filter((value) => value != null).map((value) => number(value, 3));
              this.read.textContent = read.length ? `${place(self.data[0][k])}: ${read.join(" | ")} ${unit}` : "";
            },
          ],
        },
      },
      tables.length > 1 ? uPlot.join(tables) : tables[0],
      this.box,
    );
    // Rows of the joined table that belong to the spectrum around the cursor.
    const rows = new Map(this.plot.data[0].map((x, k) => [x, k]));
    this.rows = this.passing ? Array.from(this.passing.lines.data, (x) => rows.get(x)) : [];
    this.piece = -1;
  }

  /** @param {number} t */
  cursor(t) {
    this.time = t;
    if (this.element.hidden) return;
    this.waterfall.cursor(t);
    if (!this.plot || !this.passing) return;
    const { times, lines, levels } = this.passing;
    const piece = nearest(times.data, t);
    if (piece === this.piece) return;
    this.piece = piece;
    const data = this.plot.data.slice();
    const column = new Array(data[0].length).fill(undefined);
    this.rows.forEach((row, k) => {
      const level = levels.data[piece * lines.data.length + k];
      column[row] = level ? amplitudeOf(this.passing, level) * this.shown.scale : null;
    });
    // Rows of other series within a gap belong to the gap.
    this.rows.forEach((row, k) => {
      const next = this.rows[k + 1];
      if (next > row + 1 && (column[row] === null || column[next] === null)) column.fill(null, row + 1, next);
    });
    data[data.length - 1] = column;
    // A new plot requires new scales; a plot zoomed by the user keeps its own.
    const drawn = this.plot.scales.x.min != null;
    this.plot.setData(data, !drawn);
    if (drawn) this.plot.redraw();
  }

  /** State for tests and for pages that control the viewer. */
  state() {
    if (this.element.hidden) return null;
    const near = this.passing && this.plot ? this.rows.map((row) => this.plot.data.at(-1)[row]) : [];
    const maps = this.waterfall.drawn.map(({ plot, line }) => ({
      cursor: plot.posToVal(new DOMMatrix(getComputedStyle(line).transform).m41, "x"),
    }));
    return { channel: this.name, over: this.over, ways: this.waysOf(this.name), near, maps };
  }

  resize() {
    if (this.element.hidden) return;
    const caption = this.element.querySelector(".ppv-caption");
    const height = Math.max(90, this.element.parentElement.clientHeight - caption.offsetHeight - 8);
    this.maps_box.style.height = `${height}px`;
    if (!this.maps_box.hidden) this.waterfall.resize();
    this.plot?.setSize({ width: Math.max(120, this.box.clientWidth), height });
    this.cursor(this.time);
  }
}
