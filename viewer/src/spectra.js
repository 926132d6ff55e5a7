// SPDX-License-Identifier: Apache-2.0
// Amplitudes over frequency, where a scene brings them.
import uPlot from "uplot";
import { choice, el } from "./dom.js";
import { colourOfChannel } from "./colours.js";
import { number } from "./numbers.js";

export class Spectra {
  /** @param {any[][]} spectra of each result @param {any[][]} channels of each result, for their labels */
  constructor(spectra, channels) {
    this.spectra = spectra;
    this.names = [...new Set(spectra.flat().map((spectrum) => spectrum.channel))];
    const label = (name) => channels.flat().find((channel) => channel.name === name)?.label ?? name;
    this.name = this.names[0];
    this.box = el("div", { className: "ppv-box" });
    this.read = el("output", {});
    this.choice = choice(
      "spectrum of",
      this.names.map((name) => [name, label(name)]),
      (name) => {
        this.name = name;
        this.build();
      },
    );
    this.log = true;
    this.element = el(
      "div",
      { className: "ppv-spectra" },
      el("div", { className: "ppv-caption" }, this.choice.row, this.read),
      this.box,
    );
    this.element.hidden = true;
  }

  build() {
    this.plot?.destroy();
    const found = this.spectra.map((list) => list.find((spectrum) => spectrum.channel === this.name));
    const tables = found
      .filter(Boolean)
      .map(({ frequency, amplitude }) => [
        Array.from(frequency.data),
        Array.from(amplitude.data, (value) => (value > 0 ? value : null)),
      ]);
    const style = getComputedStyle(this.element);
    const soft = style.getPropertyValue("--v-soft").trim() || "#666",
      grid = style.getPropertyValue("--v-grid").trim() || "#ddd";
    const axis = {
      stroke: soft,
      grid: { stroke: grid, width: 1 },
      ticks: { show: false },
      font: "11px system-ui, sans-serif",
    };
    const colour = colourOfChannel(this.element, this.name, 0);
    const unit = found.find(Boolean)?.unit ?? "";
    const lines = found.flatMap((spectrum, result) =>
      spectrum
        ? [
            {
              stroke: colour,
              width: 1.2,
              dash: result ? [6, 4] : undefined,
              points: { show: false },
              spanGaps: true,
            },
          ]
        : [],
    );
    // eight decades are what an eye needs; below lies rounding
    const most = Math.max(...tables.flatMap(([, y]) => y.map((value) => value ?? 0)), 1e-300);
    this.plot = new uPlot(
      {
        width: 300,
        height: 160,
        padding: [6, 44, 0, 0],
        legend: { show: false },
        cursor: { points: { show: false }, y: false, drag: { x: true, y: false } },
        series: [{}, ...lines],
        scales: {
          x: { time: false },
          y: { distr: 3, range: (_, low) => [Math.max(low, most * 1e-8), most * 1.6] },
        },
        axes: [
          {
            ...axis,
            size: 22,
            gap: 3,
            values: (_, splits) => splits.map((x, k) => (k === splits.length - 1 ? `${x} Hz` : String(x))),
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
              const values = k == null ? [] : self.data.slice(1).map((column) => number(column[k] ?? NaN, 3));
              this.read.textContent = values.length
                ? `${number(self.data[0][k], 5)} Hz: ${values.join(" | ")} ${unit}`
                : "";
            },
          ],
        },
      },
      tables.length > 1 ? uPlot.join(tables) : tables[0],
      this.box,
    );
    this.resize();
  }

  resize() {
    if (this.element.hidden || !this.plot) return;
    this.plot.setSize({
      width: Math.max(120, this.box.clientWidth),
      height: Math.max(110, this.element.parentElement.clientHeight - 28),
    });
  }
}
