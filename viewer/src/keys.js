// SPDX-License-Identifier: Apache-2.0
// Keyboard shortcuts. They are active while the focus is inside the viewer, or anywhere on a page that the
// viewer fills.
import { round125, SLOWEST } from "./player.js";

export const KEYS = [
  ["space", "play, pause"],
  ["← →", "one frame back, forward"],
  ["Home, End", "start, end"],
  ["+ −", "faster, slower"],
  ["[ ]", "previous, next mark"],
  ["f", "fit all"],
  ["1 … 9, 0", "follow a body, none"],
  ["a e t i", "view along the axis, from the side, from above, oblique"],
  ["o", "parallel or central projection"],
  ["s, S", "section; parallel to the screen"],
  ["p, P", "move the section"],
  ["m", "vibrations ×1, ×10, ×100, ×1000"],
  ["drag", "rotate; right button or Shift: pan"],
  ["wheel", "zoom at the pointer"],
  ["double click", "follow the body of a part"],
];

/** @param {import("./page.js").Page} page */
export function keys(page) {
  const does = {
    " ": () => page.toggle(),
    ArrowLeft: () => page.step(-1),
    ArrowRight: () => page.step(1),
    Home: () => page.seek(page.player.window[0]),
    End: () => page.seek(page.player.window[1]),
    "+": () => speed(page, 2.1),
    "=": () => speed(page, 2.1),
    "-": () => speed(page, 1 / 2.1),
    "[": () => page.transport.toMark(-1),
    "]": () => page.transport.toMark(1),
    f: () => page.views?.fit(),
    a: () => page.views?.named("axis"),
    e: () => page.views?.named("side"),
    t: () => page.views?.named("top"),
    i: () => page.views?.named("iso"),
    o: () => page.project(!page.stage?.parallel),
    s: () => page.section?.turn(!page.section.on),
    S: () => page.section?.facing(),
    p: () => page.section?.move(0.01),
    P: () => page.section?.move(-0.01),
    m: () => magnify(page),
    Escape: () => page.panels.close(),
  };
  page.root.tabIndex = -1;
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const { target } = event;
    const inside = page.root.contains(target);
    const fills = target === document.body && page.fills;
    if (!inside && !fills) return;
    if (target.matches?.("select, input[type=search], input[type=text]")) return;
    const slider = target.matches?.("input[type=range]") && target !== page.transport.range;
    if (slider && /^(Arrow|Home|End)/.test(event.key)) return;
    // The browser uses the space bar to press the focused button.
    if (event.key === " " && target.matches?.("button, input[type=checkbox]")) return;
    if (/^[0-9]$/.test(event.key)) page.follow(Number(event.key) - 1);
    else if (does[event.key]) does[event.key]();
    else return;
    event.preventDefault();
  });
}

function speed(page, factor) {
  const { player, transport } = page;
  player.speed = Math.max(SLOWEST, Math.min(1, round125(player.speed * factor)));
  transport.speed.set(player.speed);
}

function magnify(page) {
  if (!page.magnification) return;
  const now = page.stage.pictures[0].poses.magnification;
  const next = now >= 1000 ? 1 : now >= 100 ? 1000 : now >= 10 ? 100 : 10;
  page.magnification.set(next);
  page.magnify(next);
}
