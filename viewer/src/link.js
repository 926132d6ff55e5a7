// SPDX-License-Identifier: Apache-2.0
// View of a page as text, in its address after #: run.view.html#view=axis&projection=parallel&section=z,0.012&t=0.01
import { Vector3 } from "three";

const VIEWS = ["axis", "side", "front", "top", "iso"];
const KNOWN = ["view", "projection", "section", "t", "look", "follow"];

/** View specified by the address of the page. @returns {Record<string, string>} */
export function fromAddress() {
  const asked = new URLSearchParams(location.hash.slice(1));
  return Object.fromEntries([...asked].filter(([key]) => KNOWN.includes(key)));
}

const numbers = (text) => text.split(",").map(Number);

/**
 * Set the initial view of a page; values that are not understood are ignored.
 * @param {import("./page.js").Page} page
 * @param {Record<string, string>} asked
 */
export function begin(page, asked) {
  const { t, view, projection, section, follow, look } = asked;
  if (t !== undefined && Number.isFinite(Number(t))) page.seek(Number(t));
  if (!page.stage) return;
  if (follow !== undefined) page.follow(page.views.names.indexOf(follow));
  if (projection) page.project(projection === "parallel");
  if (VIEWS.includes(view)) page.views.named(view, true);
  if (look) {
    // The target, the direction to the camera, and the visible height.
    const [x, y, z, a, b, c, height] = numbers(look);
    if (height > 0) page.views.look([x, y, z], [a, b, c], height);
  }
  if (section) {
    const [normal, at] = section.split(",").length > 2 ? [numbers(section).slice(0, 3), numbers(section)[3]] : section.split(",");
    page.section.set(normal, at === undefined ? undefined : Number(at));
  }
  page.draw();
}

const short = (x) => String(Number(x.toPrecision(7)));

/** Address of the page with its current view. @param {import("./page.js").Page} page */
export function addressOf(page) {
  const { stage, orbit, section, views, player } = page;
  const asked = new URLSearchParams();
  if (player.times.length > 1) asked.set("t", short(player.time));
  if (stage) {
    const { target, distance } = orbit.now;
    const height = 2 * distance * Math.tan((stage.camera.fov * Math.PI) / 360);
    const all = [...target.toArray(), ...orbit.direction().toArray(), height];
    asked.set("look", all.map(short).join());
    if (stage.parallel) asked.set("projection", "parallel");
    if (section.on) asked.set("section", [...new Vector3().copy(section.normal).toArray(), section.at].map(short).join());
    if (views.body >= 0) asked.set("follow", views.names[views.body]);
  }
  return `${location.href.split("#")[0]}#${asked.toString().replaceAll("%2C", ",")}`;
}
