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

  for (const node of document.querySelectorAll(".plot")) {
    const figure = JSON.parse(node.nextElementSibling.textContent);
    const config = { responsive: true, displaylogo: false, displayModeBar: hovering ? "hover" : false,
      modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"] };
    if (figure.layout.template === undefined) figure.layout.template = {};
    Plotly.newPlot(node, figure.data, figure.layout, config);
    plots.push({ node, height: figure.layout.height });
  }
  apply(current());
  dark.addEventListener("change", () => apply(current()));
  window.addEventListener("beforeprint", () => apply("light", true));
  window.addEventListener("afterprint", () => apply(current()));
  document.documentElement.dataset.ready = String(plots.length);
})();
