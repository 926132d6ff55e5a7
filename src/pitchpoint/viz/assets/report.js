"use strict";
(() => {
  const colours = JSON.parse(document.getElementById("pp-colours").textContent);
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  // Without a mouse the tool bar would stand over the legend for good; pinching and double taps do its work there.
  const hovering = window.matchMedia("(hover: hover)").matches;
  const plots = [];

  // Settings that depend on light or dark, as one flat update of a layout.
  function look(layout, mode) {
    const c = colours[mode];
    const update = { paper_bgcolor: c.paper, plot_bgcolor: c.paper, "font.color": c.ink };
    update["hoverlabel.bgcolor"] = c.paper;
    update["hoverlabel.font.color"] = c.ink;
    for (const name of Object.keys(layout)) {
      if (/^[xy]axis\d*$/.test(name) && layout[name].visible !== false) {
        update[name + ".gridcolor"] = c.grid;
        update[name + ".zerolinecolor"] = c.grid;
        update[name + ".linecolor"] = c.soft;
        update[name + ".tickcolor"] = c.soft;
      }
    }
    return update;
  }

  // Paper is white and its width is known: 182 mm between the margins, two plots in a pair.
  const paperWidth = (node) => (node.closest(".pair") ? 325 : 680);

  // Rows with a name each, and diagrams full of names, need their height; other plots are lower on paper, those of a
  // mesh cycle more, so that they share a page.
  const paperHeight = (height, meta) => Math.round((meta && meta.whole ? 1 : meta && meta.low ? 0.7 : 0.8) * height);

  function apply(mode, printing) {
    for (const { node, height } of plots) {
      const size = printing
        ? { width: paperWidth(node), height: paperHeight(height, node.layout.meta), autosize: false }
        : { width: null, height, autosize: true };
      Plotly.relayout(node, Object.assign(look(node.layout, mode), size));
    }
  }

  const current = () => (dark.matches ? "dark" : "light");

  // Numbers of a trace, as they stand in the page: plain, or single precision in base 64.
  function numbers(values) {
    if (!values || values.bdata === undefined) return Array.from(values || []);
    const bytes = Uint8Array.from(atob(values.bdata), (c) => c.charCodeAt(0));
    return Array.from(values.dtype === "f8" ? new Float64Array(bytes.buffer) : new Float32Array(bytes.buffer));
  }

  // Whole numbers of one or two bytes, plain, or packed as differences.
  function whole({ dtype, bdata, packed, size }) {
    const bytes = Uint8Array.from(atob(packed || bdata), (c) => c.charCodeAt(0));
    if (!packed) return dtype === "u2" ? new Uint16Array(bytes.buffer) : bytes;
    if (dtype === "u1") return inflate(bytes, size);
    const planes = inflate(bytes, 3 * size), found = new Uint16Array(size);
    for (let k = 0, sum = 0; k < size; k++) {
      const gap = planes[k] | (planes[size + k] << 8) | (planes[2 * size + k] << 16);
      found[k] = sum += gap & 1 ? -(gap + 1) / 2 : gap / 2;
    }
    return found;
  }

  // Lines whose numbers stand in the page as steps (figure_file.py).
  function unpacked(text) {
    const figure = JSON.parse(text);
    for (const trace of figure.data) {
      for (const [letter, [offset, step, even]] of Object.entries((trace.meta || {}).steps || {})) {
        const owner = letter === "means" ? trace.meta : trace;
        let sum = 0;
        owner[letter] = even ? Float64Array.from({ length: even }, (_, k) => offset + step * k)
          : owner[letter].dtype === "u1" ? Float64Array.from(whole(owner[letter]), (gap) => offset + step * (sum += gap))
          : Float64Array.from(whole(owner[letter]), (k) => offset + step * k);
      }
    }
    return figure;
  }

  // Orders of another shaft are the same picture over another axis: the reader chooses whose they are.
  function offerShafts(node, figure) {
    const { shaft, speeds, overSpeed } = figure.layout.meta.orders;
    const label = document.createElement("label");
    const select = document.createElement("select");
    for (const name of Object.keys(speeds)) select.add(new Option(name, name, name === shaft, name === shaft));
    label.className = "shaft";
    label.append("orders of ", select);
    node.before(label);
    const { xaxis, yaxis, annotations = [], shapes = [] } = figure.layout;
    const end = node.layout.xaxis.range.slice(), bottom = node.layout.yaxis.range.slice();
    const title = (axis, name) => axis.title.text.replace(` of ${shaft}`, () => ` of ${name}`);
    select.addEventListener("change", () => {
      const faster = Math.abs(speeds[select.value] / speeds[shaft]);
      const scaled = (values, by) => numbers(values).map((v) => v * by);
      const data = { x: figure.data.map((trace) => scaled(trace.x, 1 / faster)) };
      const layout = { "xaxis.title.text": title(xaxis, select.value), "xaxis.range": end.map((v) => v / faster) };
      if (overSpeed) {
        data.y = figure.data.map((trace) => scaled(trace.y, faster));
        layout["yaxis.title.text"] = title(yaxis, select.value);
        layout["yaxis.range"] = bottom.map((v) => v * faster);
      }
      annotations.forEach((note, k) => {
        layout[`annotations[${k}].x`] = note.x / faster;
        // numbers at peaks are orders; names of meshes remain
        if (!note.name) layout[`annotations[${k}].text`] = String(Number((note.x / faster).toPrecision(4)));
      });
      shapes.forEach((line, k) => {
        layout[`shapes[${k}].x0`] = line.x0 / faster;
        layout[`shapes[${k}].x1`] = line.x1 / faster;
      });
      Plotly.update(node, data, layout);
    });
  }

  // Where a column of pixels has several samples, a curve is the mean of each column, in a transparent band from the
  // least to the largest sample; zooming shows the samples.
  const COLUMNS = 600, ASIDE = 60, DENSE = 2.5;

  function between(curve, low, high, columns, line, band) {
    const { x, y, means } = curve;
    if (high - low <= DENSE * columns) {
      for (let k = low; k < high; k++) line.x.push(x[k]), line.y.push(y[k]);
      return;
    }
    const places = [], least = [], most = [];
    for (let column = 0; column < columns; column++) {
      const first = low + Math.floor((column * (high - low)) / columns);
      const end = low + Math.floor(((column + 1) * (high - low)) / columns);
      let sum = 0, down = y[first], up = y[first];
      for (let k = first; k < end; k++) {
        sum += means ? means[k >> 2] : y[k];
        if (y[k] < down) down = y[k];
        if (y[k] > up) up = y[k];
      }
      places.push(column ? 0.5 * (x[first] + x[end - 1]) : x[first]);
      least.push(down);
      most.push(up);
      line.y.push(sum / (end - first));
    }
    places[columns - 1] = x[high - 1];
    line.x.push(...places);
    band.x.push(...places, ...places.reverse(), null);
    band.y.push(...least, ...most.reverse(), null);
  }

  // Line and band of a curve within a range of its axis; the ranges of the axes stay those of the whole record.
  function thinned(curve, [from, to], columns) {
    const { x } = curve, line = { x: [], y: [] }, band = { x: [], y: [] };
    const place = (t) => {
      let low = 0, high = x.length;
      while (low < high) {
        const middle = (low + high) >> 1;
        if (x[middle] < t) low = middle + 1;
        else high = middle;
      }
      return low;
    };
    const low = Math.max(0, place(from) - 1), high = Math.min(x.length, place(to) + 1);
    between(curve, 0, low, ASIDE, line, band);
    between(curve, low, high, columns, line, band);
    between(curve, high, x.length, ASIDE, line, band);
    return [line, band];
  }

  const width = (node) => Math.max(200, Math.round(node.clientWidth));

  // Curves over time with more samples than a screen has columns; their bands come first, behind all lines.
  function longCurves(node, figure) {
    if (!figure.layout.meta || !figure.layout.meta.clock) return [];
    const long = figure.data.filter(({ x, y }) => y instanceof Float64Array && x instanceof Float64Array &&
      y.length > DENSE * COLUMNS);
    const bands = long.map(({ name, xaxis, yaxis, line: { color } }) => ({ type: "scatter", mode: "lines", name, xaxis, yaxis,
      fill: "toself", fillcolor: `${color}44`, line: { width: 0 }, hoverinfo: "skip", showlegend: false, meta: {} }));
    const curves = long.map((trace, k) => ({ trace, band: bands[k], curve: { x: trace.x, y: trace.y, means: trace.meta.means } }));
    for (const { trace, band, curve } of curves) {
      const [line, own] = thinned(curve, [-Infinity, Infinity], width(node));
      Object.assign(trace, line);
      Object.assign(band, own);
    }
    figure.data.unshift(...bands);
    return curves.map(({ trace, band, curve }) => ({ curve, at: [figure.data.indexOf(trace), figure.data.indexOf(band)] }));
  }

  function followZoom(node, long) {
    let last = "";
    node.on("plotly_relayout", () => {
      const { xaxis } = node._fullLayout;
      const range = xaxis.range.slice(), columns = Math.max(200, Math.round(xaxis._length));
      if (last === (last = [...range, columns].join())) return;
      const drawn = long.flatMap(({ curve }) => thinned(curve, range, columns));
      Plotly.restyle(node, { x: drawn.map(({ x }) => x), y: drawn.map(({ y }) => y) }, long.flatMap(({ at }) => at));
    });
  }

  // Plots below each other over the same axis: all labels get the room of the widest, so that the axes are aligned.
  function align(section) {
    const groups = new Map();
    for (const { node } of plots) {
      if (node.closest("section") !== section || !node.layout.xaxis.title) continue;
      const key = [node.layout.xaxis.title.text, Math.round(node.getBoundingClientRect().left)].join();
      groups.set(key, [...(groups.get(key) || []), node]);
    }
    for (const group of groups.values()) {
      const rooms = group.flatMap((node) => Object.keys(node.layout)
        .filter((name) => /^yaxis\d*$/.test(name) && node.layout[name].visible !== false && node.layout[name].title)
        .map((name) => {
          const labels = node.querySelectorAll(`.y${name.slice(5)}tick text`);
          const wide = Math.max(0, ...[...labels].map((label) => label.getBoundingClientRect().width));
          return { node, name, wide, standoff: node.layout[name].title.standoff || 0 };
        }));
      if (rooms.length < 2) continue;
      const widest = Math.max(...rooms.map(({ wide }) => wide));
      const moved = group.map((node) => {
        const update = {};
        for (const { name, wide, standoff } of rooms.filter((room) => room.node === node))
          update[`${name}.title.standoff`] = standoff + widest - wide;
        return Plotly.relayout(node, update);
      });
      Promise.all(moved).then(() => {
        const edge = (side) => Math.max(...group.map((node) => node._fullLayout._size[side]));
        const [left, right] = [edge("l"), edge("r")];
        for (const node of group) Plotly.relayout(node, { "margin.l": left, "margin.r": right });
      });
    }
  }

  // Plots are drawn one after the other, those in sight first, so that a long page answers from the start.
  function draw(node) {
    if (node.dataset.drawn) return;
    node.dataset.drawn = "1";
    const text = node.nextElementSibling.textContent;
    const figure = unpacked(text);
    const long = longCurves(node, figure);
    // what is shown here is nobody else's: the button of the library that uploads a plot goes
    const config = { responsive: true, displaylogo: false, showSendToCloud: false, plotlyServerURL: "",
      displayModeBar: hovering ? "hover" : false,
      modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"] };
    if (figure.layout.template === undefined) figure.layout.template = {};
    Plotly.newPlot(node, figure.data, figure.layout, config);
    plots.push({ node, height: figure.layout.height });
    const { meta } = figure.layout;
    // the library writes into the figure it is given; what is offered starts from an untouched one
    if (meta && meta.orders) offerShafts(node, unpacked(text));
    if (long.length) followZoom(node, long);
    if (meta && meta.clock && node.closest(".linked")) link(node, meta.clock);
    Plotly.relayout(node, look(node.layout, current()));
    const section = node.closest("section");
    if (section && !section.querySelector(".plot:not([data-drawn])")) align(section);
  }

  // The time of the scene stands in every curve of its run, and a click into a curve moves the scene.
  const lines = [];
  let time = null;

  function link(node, clock) {
    const line = document.createElement("div");
    line.className = "now";
    node.append(line);
    lines.push({ node, clock, line });
    let from = null;
    node.addEventListener("pointerdown", (event) => (from = event.button ? null : event.clientX), true);
    window.addEventListener("pointerup", (event) => {
      const { xaxis, _size } = node._fullLayout;
      const x = event.clientX - node.getBoundingClientRect().left - _size.l;
      const still = from !== null && Math.abs(event.clientX - from) < 4;
      from = null;
      if (still && x >= 0 && x <= xaxis._length && window.pitchpointViewer)
        pitchpointViewer.seek(xaxis.p2l(x) / clock);
    }, true);
    node.on("plotly_afterplot", place);
    place();
  }

  function place() {
    for (const { node, clock, line } of lines) {
      const { xaxis, _size } = node._fullLayout;
      const x = time === null ? NaN : xaxis.l2p(time * clock);
      line.hidden = !(x >= 0 && x <= xaxis._length);
      if (line.hidden) continue;
      Object.assign(line.style, { left: `${_size.l + x}px`, top: `${_size.t}px`, height: `${_size.h}px` });
    }
  }

  document.addEventListener("pp-time", (event) => {
    time = event.detail;
    place();
  });
  for (const button of document.querySelectorAll(".when")) {
    button.addEventListener("click", () => {
      pitchpointViewer.seek(Number(button.dataset.time));
      document.getElementById("scene").scrollIntoView();
    });
  }

  // Paper gets the scene as the picture it is at that moment, and everything that is folded.
  const still = document.getElementById("pp-still");
  function keepStill() {
    const canvas = document.querySelector(".ppv-canvas");
    if (!still || !canvas || !window.pitchpointViewer) return;
    pitchpointViewer.draw();
    still.src = cropped(canvas).toDataURL("image/png");
    still.hidden = false;
  }

  // The part of a picture that differs from its corner, with a margin: a wide window is mostly background.
  function cropped(canvas) {
    const { width, height } = canvas;
    const copy = Object.assign(document.createElement("canvas"), { width, height });
    const pen = copy.getContext("2d");
    pen.drawImage(canvas, 0, 0);
    const pixels = new Uint32Array(pen.getImageData(0, 0, width, height).data.buffer);
    let left = width, right = -1, top = height, bottom = -1;
    for (let k = 0; k < pixels.length; k++) {
      if (pixels[k] === pixels[0]) continue;
      const x = k % width, y = (k - x) / width;
      left = Math.min(left, x), right = Math.max(right, x);
      top = Math.min(top, y), bottom = Math.max(bottom, y);
    }
    if (right < left) return canvas;
    const margin = Math.round(0.02 * width);
    const x = Math.max(0, left - margin), y = Math.max(0, top - margin);
    const size = { width: Math.min(width, right + margin) - x, height: Math.min(height, bottom + margin) - y };
    const part = Object.assign(document.createElement("canvas"), size);
    part.getContext("2d").drawImage(canvas, -x, -y);
    return part;
  }

  // The page takes the width of paper before it is printed: what is then still wider shrinks.
  function fit(printing) {
    document.documentElement.classList.toggle("paper", printing);
    const tables = document.querySelectorAll("table");
    for (const table of tables) table.style.zoom = "";
    if (!printing) return;
    const { clientWidth } = document.querySelector("main");
    for (const table of tables) {
      if (table.scrollWidth > clientWidth) table.style.zoom = String(clientWidth / table.scrollWidth);
    }
  }

  // The library for plots stands in the page packed. It is there at once, as a printer may be before anything else.
  function library() {
    const packed = document.getElementById("pp-plots");
    if (!packed || window.Plotly) return;
    const bytes = Uint8Array.from(atob(packed.textContent), (c) => c.charCodeAt(0));
    const script = document.createElement("script");
    script.textContent = new TextDecoder().decode(inflate(bytes, Number(packed.dataset.size)));
    document.head.append(script);
  }

  const waiting = [...document.querySelectorAll(".plot")];
  function rest() {
    for (const node of waiting.splice(0)) draw(node);
  }
  function next() {
    const sight = waiting.findIndex((node) => {
      const box = node.getBoundingClientRect();
      return box.bottom > 0 && box.top < window.innerHeight;
    });
    const [node] = waiting.splice(Math.max(0, sight), 1);
    if (node) draw(node);
    if (waiting.length) setTimeout(next);
    else document.documentElement.dataset.ready = String(plots.length);
  }

  dark.addEventListener("change", () => apply(current()));
  window.addEventListener("beforeprint", () => {
    keepStill();
    rest();
    for (const folded of document.querySelectorAll("details:not([open])")) {
      folded.open = true;
      folded.dataset.folded = "1";
    }
    fit(true);
    apply("light", true);
  });
  window.addEventListener("afterprint", () => {
    for (const node of document.querySelectorAll("[data-folded]")) node.open = false;
    fit(false);
    apply(current());
  });
  library();
  next();
})();
