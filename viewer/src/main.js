// SPDX-License-Identifier: Apache-2.0
// Entry point: pitchpointViewer.mount(element, {compare}) shows the scene of the page in an element.
import uplotStyle from "uplot/dist/uPlot.min.css";
import style from "./style.css";
import { el } from "./dom.js";
import { changeFlanks, showGauge } from "./flanks.js";
import { begin, fromAddress } from "./link.js";
import { Page } from "./page.js";
import { movingSolids, png, stl } from "./save.js";
import { SceneError, readScene } from "./scene_file.js";
import { stateOf } from "./state.js";

/** @type {Page|null} the viewer mounted last */
let page = null;

/**
 * @param {HTMLElement} element is filled by the viewer and determines its size
 * @param {{compare?: boolean, start?: Record<string, string>}} options compare: the page contains two scenes;
 *   start: initial view, as in the address of the page (link.js)
 * @returns {Promise<boolean>} whether a scene is shown; otherwise the element shows a message with the reason
 */
async function mount(element, { compare = false, start = {} } = {}) {
  if (!document.getElementById("ppv-style"))
    document.head.append(el("style", { id: "ppv-style" }, uplotStyle + style));
  const root = el("div", { className: "ppv" });
  const message = el("p", {}, "Reading the scene …");
  root.append(el("div", { className: "ppv-message", role: "status" }, message));
  element.replaceChildren(root);
  try {
    const scenes = [await readScene()];
    if (compare) scenes.push(await readScene("-2"));
    page = new Page(root, scenes);
    begin(page, { ...start, ...fromAddress() });
    root.dataset.ready = "scene";
    return true;
  } catch (error) {
    message.textContent =
      error instanceof SceneError
        ? error.message
        : `Internal error of the viewer: ${error instanceof Error ? error.message : error}.`;
    root.replaceChildren(el("div", { className: "ppv-message", role: "alert" }, message));
    root.dataset.ready = "failed";
    if (!(error instanceof SceneError)) console.error(error);
    return false;
  }
}

const shown = () => {
  if (!page) throw new Error("No scene is displayed.");
  return page;
};

/** Print on a white background, also with a dark colour scheme, and sharp, also in a small window. @param {boolean} on */
function onPaper(on) {
  page?.stage?.enlarge(on);
  if (page?.stage) page.stage.background.set(on ? "#ffffff" : getComputedStyle(page.area).backgroundColor);
  if (page && !on) page.draw();
}
window.addEventListener("beforeprint", () => onPaper(true));
window.addEventListener("afterprint", () => onPaper(false));

window.pitchpointViewer = {
  mount,
  state: () => (page ? stateOf(page) : null),
  seek: (t) => shown().seek(t),
  play: () => shown().toggle(true),
  pause: () => shown().toggle(false),
  step: (frames) => shown().step(frames),
  repeat: (what) => shown().loop(what),
  advance: (dt) => shown().advance(dt),
  follow: (body) => shown().follow(body),
  /** View of a target point [m] from a direction; `height` is the visible height at the target [m]. */
  look: (target, direction, height) => shown().views?.look(target, direction, height),
  view: (name) => shown().views?.named(name, true),
  /** @param {"parallel"|"central"} projection */
  project: (projection) => shown().project(projection === "parallel"),
  /**
   * Section normal to x, y, z, the axis of the shafts or a direction; none: no section.
   * @param {"x"|"y"|"z"|"axis"|number[]|null} normal
   * @param {number} [at] position along the normal [m]; default: the middle
   */
  section: (normal, at) => (normal ? shown().section?.set(normal, at) : shown().section?.turn(false)),
  show: (channel, on = true) => shown().curves.plots.show(channel, on),
  /**
   * Show a spectrum instead of curves.
   * @param {string} channel
   * @param {string} [over] as listed on the page: frequency, orders of …
   */
  spectrum: (channel, over) => shown().curves.spectrum(channel, over),
  magnify: (times) => shown().magnify(times),
  /** @param {string} kind kind of arrows: mesh, pair or bearing */
  arrows: (kind, on = true) => shown().arrows(kind, on),
  /** @param {"sparse"|"all"} which arrows */
  density: (which) => shown().density(which === "sparse"),
  lines: (on = true) => changeFlanks(shown(), (flanks) => (flanks.showsLines = on)),
  /** @param {"off"|"all"|"each"} mode */
  pattern: (mode) => changeFlanks(shown(), (flanks) => (flanks.mode = mode)),
  /** Quantity shown by the flank colours. @param {"load"|"pressure"} what */
  shade: (what) => changeFlanks(shown(), (flanks) => (flanks.shade = flanks.pressures ? what : "load")),
  /** @param {number} mesh -1 none @param {number} times */
  gauge: (mesh, times) => showGauge(shown(), mesh, times),
  /** Scene of a model that runs in the page: write one-row tables and draw. @param {(scene: any) => void} change */
  live: (change) => shown().live(change),
  mode: (number) => shown().modes.choose(number),
  /** @param {"png"|"glb"|"stl"} kind @returns {Blob} */
  file: (kind, times = 1) =>
    kind === "png" ? png(shown(), times) : kind === "glb" ? movingSolids(shown()) : stl(shown()),
  /** Draw the final camera position without easing. */
  draw: () => {
    shown().orbit?.settle();
    shown().draw();
  },
};
