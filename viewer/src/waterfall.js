// SPDX-License-Identifier: Apache-2.0
// Maps of spectra over time (spectrograms): time horizontal, frequency or order vertical, level in decibels
// as colour.
import uPlot from "uplot";
import { el } from "./dom.js";
import { gradient, loadColour } from "./load_colours.js";
import { number, within } from "./numbers.js";
import { labels } from "./plots.js";

/** Width of the colour scale next to maps [px]. */
const SCALE = 92;

/**
 * Range of a map axis: from half a cell before the first to half a cell after the last centre.
 * @param {ArrayLike<number>} middles even or uneven
 */
function span(middles) {
  const n = middles.length;
  return [1.5 * middles[0] - 0.5 * middles[1], 1.5 * middles[n - 1] - 0.5 * middles[n - 2]];
}

/** Index of the nearest value of an ascending list. @param {ArrayLike<number>} places @param {number} x */
export function nearest(places, x) {
  let low = 0,
    high = places.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (places[middle] <= x) low = middle;
    else high = middle;
  }
  return x - places[low] < places[high] - x ? low : high;
}

/**
 * Amplitude of a level of a map; level 0 includes all smaller amplitudes.
 * @param {any} map
 * @param {number} level
 */
export const amplitudeOf = (map, level) => map.most * 10 ** ((level / 255 - 1) * (map.decibels / 20));

/** Factor and unit of a frequency axis. @param {number[]} ends upper limits [Hz] */
export const frequencyUnit = (ends) => (Math.max(...ends) > 1e4 ? [1e-3, "kHz"] : [1, "Hz"]);

export class Waterfall {
  /**
   * @param {HTMLElement} element
   * @param {(t: number) => void} seek
   * @param {(text: string) => void} announce
   */
  constructor(element, seek, announce) {
    this.element = element;
    this.seek = seek;
    this.announce = announce;
    this.drawn = [];
    this.time = 0;
  }

  destroy() {
    for (const { plot } of this.drawn) plot.destroy();
    this.drawn = [];
    this.element.replaceChildren();
  }

  /**
   * @param {any[]} maps of each result
   * @param {{soft: string, grid: string, paper: string}} inks
   * @param {{unit: string, scale: number}} shown
   */
  build(maps, inks, shown) {
    this.destroy();
    this.shown = shown;
    for (const map of maps) {
      const box = el("div", { className: "ppv-box" });
      this.element.append(box);
      this.drawn.push({ ...this.#plot(map, box, inks), box, map });
    }
    const [first] = maps;
    // The reference of each map is its own maximum.
    const worth = [...new Set(maps.map(({ most }) => number(most * shown.scale, 3)))].join(" | ");
    this.element.append(
      el(
        "div",
        { className: "ppv-map-scale", title: "Amplitudes relative to the maximum of the map" },
        el("i", { style: `background:${gradient().replace("to right", "to top")}` }),
        el("span", {}, `0 dB = ${worth} ${shown.unit === "1" ? "" : shown.unit}`),
        el("span", {}, `\u2212${first.decibels} dB`),
      ),
    );
    this.resize();
  }

  #plot(map, box, inks) {
    const times = Array.from(map.times.data),
      lines = Array.from(map.lines.data);
    const [left, right] = span(times),
      [low, high] = span(lines);
    const picture = image(map.levels.data, times.length, lines.length);
    const axis = {
      stroke: inks.soft,
      grid: { show: false },
      ticks: { show: false },
      font: "11px system-ui, sans-serif",
    };
    const [per, unit] = map.of ? [1, "order"] : frequencyUnit([lines.at(-1)]);
    const plot = new uPlot(
      {
        width: 300,
        height: 160,
        padding: [6, 30, 0, 0],
        legend: { show: false },
        cursor: { show: false },
        series: [{}, { show: false }],
        scales: { x: { time: false, range: () => [left, right] }, y: { range: () => [Math.max(0, low), high] } },
        axes: [
          { ...axis, size: 22, gap: 3, values: (_, splits) => labels(splits, "s") },
          { ...axis, size: 62, gap: 4, space: 28, values: (_, splits) => labels(splits.map((x) => x * per), unit) },
        ],
        hooks: {
          draw: [() => this.cursor(this.time)],
          drawClear: [
            (self) => {
              const { ctx, bbox } = self;
              const top = self.valToPos(high, "y", true),
                bottom = self.valToPos(low, "y", true);
              ctx.save();
              ctx.beginPath();
              ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
              ctx.clip();
              ctx.imageSmoothingEnabled = false;
              ctx.drawImage(picture, bbox.left, top, bbox.width, bottom - top);
              ctx.restore();
            },
          ],
        },
      },
      [times, times.map(() => null)],
      box,
    );
    const line = el("div", { className: "ppv-cursor" });
    plot.over.append(line);
    this.#pointer(plot, map, times, lines);
    return { plot, line };
  }

  #pointer(plot, map, times, lines) {
    const { over } = plot;
    const at = (event, scale) => {
      const box = over.getBoundingClientRect();
      return plot.posToVal(scale === "x" ? event.clientX - box.left : event.clientY - box.top, scale);
    };
    let down = false;
    over.addEventListener("pointerdown", (event) => {
      if (event.button) return;
      down = true;
      over.setPointerCapture?.(event.pointerId);
      this.seek(at(event, "x"));
    });
    over.addEventListener("pointermove", (event) => {
      if (down) this.seek(at(event, "x"));
      const k = nearest(lines, at(event, "y")),
        n = nearest(times, at(event, "x"));
      const level = map.levels.data[n * lines.length + k];
      const [per, hertz] = frequencyUnit([lines.at(-1)]);
      const half = (lines[1] - lines[0]) / 2;
      const what = map.of ? `order ${within(lines[k], half)}` : `${within(lines[k] * per, half * per)} ${hertz}`;
      this.announce(`${number(times[n], 4)} s, ${what}: ${level ? "" : "< "}${number(amplitudeOf(map, level) * this.shown.scale, 3)} ${this.shown.unit}`);
    });
    over.addEventListener("pointerleave", () => this.announce(""));
    for (const name of ["pointerup", "pointercancel"]) over.addEventListener(name, () => (down = false));
  }

  /** @param {number} t */
  cursor(t) {
    this.time = t;
    for (const { plot, line } of this.drawn) {
      const x = plot.valToPos(t, "x");
      line.hidden = !(x >= -0.5 && x <= plot.over.clientWidth + 0.5);
      line.style.transform = `translateX(${x}px)`;
    }
  }

  resize() {
    const width = (this.element.clientWidth - SCALE) / Math.max(1, this.drawn.length);
    for (const { plot } of this.drawn)
      plot.setSize({ width: Math.max(120, Math.floor(width)), height: Math.max(110, this.element.clientHeight) });
  }
}

/** Image of the map with one pixel per level, lowest line at the bottom. */
function image(levels, n, k) {
  const canvas = el("canvas", { width: n, height: k });
  const ink = canvas.getContext("2d");
  const pixels = ink.createImageData(n, k);
  const colours = Array.from({ length: 256 }, (_, level) => loadColour(level / 255).map((x) => Math.round(255 * x)));
  for (let x = 0; x < n; x++)
    for (let y = 0; y < k; y++) pixels.data.set([...colours[levels[x * k + y]], 255], 4 * ((k - 1 - y) * n + x));
  ink.putImageData(pixels, 0, 0);
  return canvas;
}
