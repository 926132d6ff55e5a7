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

  function apply(mode, printing) {
    for (const { node, height } of plots) {
      const size = printing
        ? { width: paperWidth(node), height, autosize: false }
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

  // Orders of another shaft are the same picture over another axis: the reader chooses whose they are.
  function offerShafts(node, figure) {
    const { shaft, speeds, overSpeed } = figure.layout.meta.orders;
    const label = document.createElement("label");
    const select = document.createElement("select");
    for (const name of Object.keys(speeds)) select.add(new Option(name, name, name === shaft, name === shaft));
    label.className = "shaft";
    label.append("orders of ", select);
    node.before(label);
    const { xaxis, yaxis, annotations = [] } = figure.layout;
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
        layout[`annotations[${k}].text`] = String(Number((note.x / faster).toPrecision(4)));
      });
      Plotly.update(node, data, layout);
    });
  }

  for (const node of document.querySelectorAll(".plot")) {
    const text = node.nextElementSibling.textContent;
    const figure = JSON.parse(text);
    const config = { responsive: true, displaylogo: false, displayModeBar: hovering ? "hover" : false,
      modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"] };
    if (figure.layout.template === undefined) figure.layout.template = {};
    Plotly.newPlot(node, figure.data, figure.layout, config);
    plots.push({ node, height: figure.layout.height });
    // the library writes into the figure it is given; what is offered starts from an untouched one
    if (figure.layout.meta && figure.layout.meta.orders) offerShafts(node, JSON.parse(text));
  }
  apply(current());
  dark.addEventListener("change", () => apply(current()));
  window.addEventListener("beforeprint", () => apply("light", true));
  window.addEventListener("afterprint", () => apply(current()));
  document.documentElement.dataset.ready = String(plots.length);
})();
