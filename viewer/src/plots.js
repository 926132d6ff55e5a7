// SPDX-License-Identifier: Apache-2.0
// Curves below the scene: one plot per unit, bands between minimum and maximum, a cursor at the current time.
import uPlot from "uplot";
import { button, el } from "./dom.js";
import { colourOfChannel, colourOfMark, isForce } from "./colours.js";
import { fixed, timeUnit } from "./numbers.js";

const LOW = 84; // minimum height of a plot [px]
const HIGH = 260; // maximum height of a plot [px]
const NARROW = 340; // minimum width of plots that are next to each other [px]
const COLUMNS = 3;
/** Minimum distance of marks of one kind [px]; all are in the list of marks. */
export const SPARSE = 4;
const AROUND = 8; // margins and borders of a row [px]
const LINE = 20; // height of a caption of one line [px]
const STRIP = 26; // height of the line with the button for the next plots [px]
/**
 * Distance of the centres of two curves, in spans, above which a common plot would show both as straight
 * lines.
 */
const APART = 4;

/**
 * Instants at which the intervals of a channel are drawn: the centre of an interval, or the start if it is
 * one sample.
 * @param {any} channel
 */
export function middles(channel) {
  const { data: starts } = channel.times;
  if (!channel.most || starts.length < 2) return Float64Array.from(starts);
  const n = starts.length;
  return Float64Array.from(starts, (t, k) => t + (k < n - 1 ? starts[k + 1] - t : t - starts[k - 1]) / 2);
}

/** A table in the displayed unit. @param {any} channel @param {any} table */
function shown(channel, table) {
  const scale = channel.scale ?? 1;
  return Float64Array.from(table.data, (value) => value * scale);
}

/** Whether a record has ended before an instant, except for rounding of frame times. */
export const ended = (end, t) => t > end + 1e-9 * Math.abs(end);

/**
 * Minimum and maximum of a channel in the interval at an instant; null after the end of the record.
 * @param {any} channel
 * @param {number} t
 * @param {number} [end] of the record
 */
export function valueAt(channel, t, end = Infinity) {
  if (ended(end, t)) return null;
  const { times, least, most } = channel;
  let low = 0,
    high = times.count;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times.data[middle] <= t) low = middle;
    else high = middle;
  }
  const scale = channel.scale ?? 1;
  return { least: least.data[low] * scale, most: (most ?? least).data[low] * scale };
}

/** Centre of a curve over all results, and its largest span in a single result. @param {any[]} found */
function extent(found) {
  const sides = found.filter(Boolean).map(({ least, most }) => {
    const of = (table, pick) => table.data.reduce((a, b) => pick(a, b), table.data[0]);
    return [of(least, Math.min), of(most ?? least, Math.max)];
  });
  const low = Math.min(...sides.map(([a]) => a)),
    high = Math.max(...sides.map(([, b]) => b));
  return { middle: (low + high) / 2, span: Math.max(...sides.map(([a, b]) => b - a)) };
}

/** Whether a common plot would hide the variation of two curves. */
function apart(a, b) {
  const span = Math.max(a.span, b.span),
    gap = Math.abs(a.middle - b.middle);
  // Two constant curves have no variation to show.
  return gap > APART * span && span > 1e-9 * gap;
}

const PARTING = { className: "ppv-parting" };

export class Plots {
  /**
   * @param {any[][]} channels of each result
   * @param {any[]} marks
   * @param {number[]} range of time
   * @param {(t: number) => void} seek
   * @param {number[]} ends of the records
   */
  constructor(channels, marks, range, seek, ends = []) {
    this.channels = channels;
    this.ends = ends;
    this.marks = marks;
    this.kinds = [...new Set(marks.map((mark) => mark.kind))];
    this.full = range;
    this.x = range;
    this.seek = seek;
    this.time = range[0];
    this.drawn = [];
    this.element = el("div", { className: "ppv-plots", tabindex: "-1" });
    /** Number of plots below the visible ones; scrolls to them. */
    this.more = button("", "Scroll to the next plots", () => this.element.scrollBy({ top: this.element.clientHeight }), {
      className: "ppv-more",
    });
    this.more.hidden = true;
    this.element.addEventListener("scroll", () => this.#count());
    this.names = new Set(
      channels
        .flat()
        .filter((channel) => channel.first)
        .map((channel) => channel.name),
    );
    this.order = [...new Set(channels.flat().map((channel) => channel.name))];
    this.onRemove = () => {};
    /** Set the minimum height of all around the plots. @type {(height: number) => void} */
    this.needs = () => {};
  }

  /** @param {string} name @param {boolean} on */
  show(name, on) {
    if (on) this.names.add(name);
    else this.names.delete(name);
    this.build();
  }

  /** Selected channels in groups of one unit and similar level, so that the variation of each is visible. */
  #groups() {
    const groups = [];
    for (const name of this.order) {
      if (!this.names.has(name)) continue;
      const found = this.channels.map((list) => list.find((channel) => channel.name === name));
      const unit = (found.find(Boolean).shown_unit ?? found.find(Boolean).unit) || "1";
      const member = { name, found, ...extent(found) };
      const near = groups.find((group) => group.unit === unit && !group.members.some((other) => apart(member, other)));
      if (near) near.members.push(member);
      else groups.push({ unit, members: [member] });
    }
    // Plots of the same unit are adjacent.
    const units = [...new Set(groups.map(({ unit }) => unit))];
    return groups.sort((a, b) => units.indexOf(a.unit) - units.indexOf(b.unit));
  }

  build() {
    for (const { plot } of this.drawn) plot.destroy();
    this.drawn = [];
    this.element.replaceChildren();
    const groups = this.#groups();
    this.ratio = window.devicePixelRatio || 1;
    // Force components have fixed colours; the other curves use a palette in turn.
    this.turns = groups
      .flatMap(({ members }) => members)
      .filter(({ name, found }) => !isForce(name) || found.find(Boolean).whole)
      .map(({ name }) => name);
    for (const { unit, members } of groups) {
      const holder = el("div", { className: "ppv-plot" });
      const caption = el("div", { className: "ppv-caption" });
      const box = el("div", { className: "ppv-box" });
      holder.append(caption, box);
      this.element.append(holder);
      const made = this.#plot(unit, members, box, caption);
      this.drawn.push({ ...made, holder, box, caption });
    }
    if (!groups.length)
      this.element.append(
        el(
          "p",
          { className: "ppv-none" },
          this.order.length ? "Choose a curve." : "This scene has no curves.",
        ),
      );
    this.resize();
    this.cursor(this.time);
  }

  /** Show the members of a group instead of it, or the group instead of its members. @param {string} name */
  part(name) {
    const all = this.channels.flat();
    const { members, whole } = all.find((channel) => channel.name === name) ?? {};
    const [from, to] = members ? [[name], members] : [all.find((channel) => channel.name === whole).members, [whole]];
    for (const each of from) this.names.delete(each);
    for (const each of to) this.names.add(each);
    this.build();
    this.onRemove();
  }

  /** Button that shows a group apart or together, for a group and the first of its members. */
  #parting(channel, shown) {
    const { name, members, whole } = channel;
    if (members) return button("apart", `Show the ${members.length} planets apart`, () => this.part(name), PARTING);
    if (!whole || shown.has(whole)) return null;
    shown.add(whole);
    return button("together", "Show the range of all planets", () => this.part(name), PARTING);
  }

  #plot(unit, members, box, caption) {
    const tables = [],
      series = [{}],
      bands = [],
      shows = [];
    const ink = getComputedStyle(this.element);
    const parted = new Set();
    members.forEach(({ name, found }) => {
      const colour = colourOfChannel(this.element, found.find(Boolean).whole ? "" : name, this.turns.indexOf(name));
      const tints = [colour, secondTint(this.element, colour)];
      const values = el("output", {});
      const first = found.find(Boolean);
      caption.append(
        el(
          "span",
          { className: "ppv-curve" },
          ...tints
            .filter((_, result) => found[result])
            .map((tint) => el("i", { style: `background:${tint}` })),
          el("span", {}, first.label ?? name),
          values,
          el("small", {}, unit === "1" ? "" : unit),
          this.#parting(first, parted),
          button("×", `Remove ${first.label ?? name}`, () => {
            this.show(name, false);
            this.onRemove();
          }),
        ),
      );
      const largest = Math.max(
        ...found
          .filter(Boolean)
          .map(
            (channel) =>
              (channel.scale ?? 1) *
              Math.max(
                ...[channel.least, channel.most ?? channel.least].map(({ data }) =>
                  data.reduce((most, x) => Math.max(most, Math.abs(x)), 0),
                ),
              ),
          ),
      );
      shows.push({ values, found, digits: fixed(largest) });
      found.forEach((channel, result) => {
        if (!channel) return;
        const dash = result ? [6, 4] : undefined;
        const line = { stroke: tints[result], width: 1.4, dash, pxAlign: 0, points: { show: false }, spanGaps: true };
        const table = [middles(channel), shown(channel, channel.least)];
        if (channel.most) {
          // the range of each piece, and the mean as a line
          table.push(shown(channel, channel.most));
          bands.push({
            series: [series.length + 1, series.length],
            fill: `color-mix(in srgb, ${tints[result]} ${result ? 12 : 26}%, transparent)`,
          });
          const edge = `color-mix(in srgb, ${tints[result]} 40%, transparent)`;
          series.push({ ...line, stroke: edge, width: 0.6 }, { ...line, stroke: edge, width: 0.6 });
          if (channel.mean) table.push(shown(channel, channel.mean));
          if (channel.mean) series.push(line);
        } else series.push(line);
        tables.push(table);
      });
    });
    const same = tables.every(
      ([x]) => x.length === tables[0][0].length && x.every((t, k) => t === tables[0][0][k]),
    );
    const data = same
      ? [tables[0][0], ...tables.flatMap(([, ...rest]) => rest)]
      : uPlot.join(tables.map((table) => table.map((column) => Array.from(column))));
    const soft = ink.getPropertyValue("--v-soft").trim() || "#666";
    const grid = ink.getPropertyValue("--v-grid").trim() || "#ddd";
    const axis = {
      stroke: soft,
      grid: { stroke: grid, width: 1 },
      ticks: { show: false },
      font: "11px system-ui, sans-serif",
    };
    const plot = new uPlot(
      {
        width: 300,
        height: LOW,
        padding: [6, 30, 0, 0],
        series,
        bands,
        legend: { show: false },
        cursor: { show: false },
        scales: { x: { time: false, range: () => this.x }, y: { range: (_, low, high) => range(low, high) } },
        axes: [
          { ...axis, size: 22, gap: 3, values: (_, splits) => timeLabels(splits) },
          { ...axis, size: room, gap: 4, space: ticks, values: (self, splits) => clear(self, splits, labels(splits)) },
        ],
        hooks: { draw: [(self) => this.#drawMarks(self)] },
      },
      data,
      box,
    );
    const line = el("div", { className: "ppv-cursor" });
    plot.over.append(line);
    this.#pointer(plot);
    return { plot, line, shows };
  }

  #drawMarks(plot) {
    const { left, top, width } = plot.bbox;
    const last = {};
    for (const mark of this.marks) {
      const x = plot.valToPos(mark.time, "x", true);
      if (x < left || x > left + width || x - (last[mark.kind] ?? -9) < SPARSE * this.ratio) continue;
      last[mark.kind] = x;
      plot.ctx.fillStyle = colourOfMark(this.kinds, mark.kind);
      plot.ctx.fillRect(x - this.ratio / 2, top, 1.2 * this.ratio, 6 * this.ratio);
    }
  }

  #pointer(plot) {
    const { over } = plot;
    const at = (event) => plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x");
    let down = false;
    over.addEventListener("pointerdown", (event) => {
      if (event.button) return;
      down = true;
      over.setPointerCapture?.(event.pointerId);
      this.seek(at(event));
    });
    over.addEventListener("pointermove", (event) => down && this.seek(at(event)));
    for (const name of ["pointerup", "pointercancel"]) over.addEventListener(name, () => (down = false));
    over.addEventListener("dblclick", () => this.zoom(this.full));
    over.addEventListener(
      "wheel",
      (event) => {
        // At the full range, zooming out scrolls the page instead.
        if (!event.ctrlKey && !event.shiftKey && event.deltaY > 0 && this.x === this.full) return;
        event.preventDefault();
        const t = at(event),
          factor = Math.exp(Math.max(-1, Math.min(1, (event.deltaY || event.deltaX) * 0.002)));
        this.zoom([t + (this.x[0] - t) * factor, t + (this.x[1] - t) * factor]);
      },
      { passive: false },
    );
  }

  /** Set the time interval of all plots. @param {number[]} range */
  zoom([a, b]) {
    const [first, last] = this.full;
    const out = b - a >= last - first;
    this.x = out ? this.full : [Math.max(first, a), Math.min(last, b)];
    for (const { plot } of this.drawn) plot.setData(plot.data);
    this.cursor(this.time);
  }

  /** Show how many plots are below, and nothing of plots that are only partly in sight there. */
  #count() {
    const { scrollTop, clientHeight, offsetTop } = this.element;
    let below = 0;
    for (const { holder } of this.drawn) {
      const cut = holder.offsetTop - offsetTop + holder.offsetHeight > scrollTop + clientHeight + 1;
      // Transparent plots can still get the focus, which scrolls to them.
      holder.style.opacity = cut ? "0" : "";
      below += Number(cut);
    }
    this.more.hidden = !below;
    this.more.textContent = `▾ ${below} more`;
    this.more.setAttribute("aria-label", `Scroll to ${below} more plot${below === 1 ? "" : "s"}`);
  }

  /** Plots are next to each other where they fit, and rows are as high as makes whole ones visible. */
  resize() {
    const count = Math.max(1, this.drawn.length);
    this.element.style.height = "";
    const { clientWidth: width } = this.element;
    const columns = Math.max(1, Math.min(count, COLUMNS, Math.floor(width / NARROW)));
    const most = Math.max(1, Math.floor(this.element.clientHeight / (LOW + LINE)));
    const used = Math.max(1, Math.min(columns, Math.ceil(count / most)));
    this.element.style.gridTemplateColumns = `repeat(${used}, minmax(0, 1fr))`;
    // Captions of many curves take several lines on narrow pages.
    const rows = [];
    this.drawn.forEach(({ caption }, k) => {
      const row = Math.floor(k / used);
      rows[row] = Math.max(rows[row] ?? 0, caption.offsetHeight);
    });
    const fitting = () => {
      const room = this.element.clientHeight - 4;
      const seen = rows.findIndex((_, n) => rows.slice(0, n + 1).reduce((sum, high) => sum + high + LOW, 0) > room);
      return { room, whole: seen < 0 ? rows.length : Math.max(1, seen) };
    };
    const fits = () => fitting().whole === rows.length;
    // The first row is always whole, at the expense of the scene.
    this.needs(this.drawn.length ? rows[0] + LOW + AROUND + (rows.length > 1 && !fits() ? STRIP : 0) : 0);
    // The button for the next plots covers nothing.
    if (!fits()) this.element.style.height = `calc(100% - ${STRIP}px)`;
    const { room, whole } = fitting();
    const captions = rows.slice(0, whole).reduce((sum, high) => sum + high, 0);
    const each = Math.max(LOW, Math.min(HIGH, Math.floor((room - captions) / whole)));
    this.drawn.forEach(({ plot, box, caption }, k) => {
      caption.style.minHeight = used > 1 ? `${rows[Math.floor(k / used)]}px` : "";
      plot.setSize({ width: Math.max(120, box.clientWidth), height: each });
    });
    // Scrolled to the end, the plots at the top are whole as well.
    const last = rows.slice(-whole).reduce((sum, high) => sum + high + each, 0);
    this.element.style.paddingBottom = whole < rows.length ? `${Math.max(0, this.element.clientHeight - last - 3)}px` : "";
    this.#count();
    this.cursor(this.time);
  }

  /** @param {number} t */
  cursor(t) {
    this.time = t;
    for (const { plot, line, shows } of this.drawn) {
      const x = plot.valToPos(t, "x");
      line.hidden = !(x >= -0.5 && x <= plot.over.clientWidth + 0.5);
      line.style.transform = `translateX(${x}px)`;
      for (const { values, found, digits } of shows) {
        const text = found
          .flatMap((channel, result) => {
            if (!channel) return [];
            const value = valueAt(channel, t, this.ends[result]);
            if (!value) return ["–"];
            const { least, most } = value;
            return [...new Set([digits(least), digits(most)])].join(" … ");
          })
          .join(" | ");
        if (values.textContent !== text) values.textContent = text;
      }
    }
  }
}

/**
 * Colour of the second of two results: darker on a light background, lighter on a dark one.
 * @param {Element} element
 * @param {string} colour
 */
export function secondTint(element, colour) {
  const ink = getComputedStyle(element).getPropertyValue("--v-ink").trim() || "#1f2933";
  return `color-mix(in srgb, ${colour} 40%, ${ink})`;
}

/**
 * Minimum tick spacing [px]; with steps of 1, 2, 2.5 and 5 an axis then has at least two ticks.
 * @param {any} _
 * @param {number} __
 * @param {number} ___
 * @param {number} ____
 * @param {number} size of the axis
 */
const ticks = (_, __, ___, ____, size) => Math.max(9, Math.min(24, size / 4));

/** Labels without those next to the labels of the time axis. */
function clear(plot, splits, texts) {
  const { min, max } = plot.scales.y;
  return texts.map((text, k) => (splits[k] - min < 0.02 * (max - min) ? "" : text));
}

/** Width of an axis for its labels [px]. @param {any} _ @param {string[]|null} values */
function room(_, values) {
  return Math.max(56, 12 + 6.6 * Math.max(0, ...(values ?? []).map((text) => text?.length ?? 0)));
}

/** A non-empty axis range with a margin. */
function range(low, high) {
  if (!(high >= low)) return [0, 1];
  // Round-off is not magnified.
  const least = 1e-7 * Math.max(Math.abs(low), Math.abs(high));
  const air = high - low > least ? 0.06 * (high - low) : 0.06 * (Math.abs(high) || 1);
  return [low - air, high + air];
}

/** Labels of a time axis in a suitable unit. @param {number[]} splits [s] */
export function timeLabels(splits) {
  const [unit, name] = timeUnit(Math.max(...splits.map(Math.abs)));
  return labels(
    splits.map((t) => t / unit),
    name,
  );
}

/**
 * Labels of an axis with a uniform number format.
 * @param {number[]} splits
 * @param {string} unit appended to the last label
 */
export function labels(splits, unit = "") {
  const most = Math.max(...splits.map(Math.abs));
  const step = splits.length > 1 ? Math.abs(splits[1] - splits[0]) : most;
  let decimals = Math.max(0, Math.min(12, -Math.floor(Math.log10(step || 1) + 1e-9)));
  // Steps such as 2.5 require one more decimal.
  if (decimals < 12 && Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) > 1e-6) decimals++;
  return splits.map((value, k) => {
    const text = most >= 1e6 || (most > 0 && most < 1e-4) ? value.toExponential(2) : value.toFixed(decimals);
    return (k === splits.length - 1 && unit ? `${text} ${unit}` : text)
      .replace(/^-(0(\.0+)?)$/, "$1")
      .replace("-", "\u2212");
  });
}
