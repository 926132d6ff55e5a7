// SPDX-License-Identifier: Apache-2.0
// The viewer in one element: connects scene, time controls, curves and panels.
import { Curves } from "./curves.js";
import { el } from "./dom.js";
import { Hover } from "./hover.js";
import { FlankBox, flankRows } from "./flanks.js";
import { keys, KEYS } from "./keys.js";
import { Legend } from "./legend.js";
import { duration, length, force } from "./numbers.js";
import { markRows } from "./marks_panel.js";
import { namesOf } from "./names.js";
import { Modes } from "./modes.js";
import { Orbit } from "./orbit.js";
import { Panels, forceRows, saveRows, vibrationRows, viewRows } from "./panels.js";
import { Player, round125 } from "./player.js";
import { ended } from "./plots.js";
import { Poses } from "./poses.js";
import { sharedFrames } from "./shared_frames.js";
import { SectionView } from "./section_view.js";
import { Stage, graphics } from "./stage.js";
import { touches } from "./touch.js";
import { Transport } from "./transport.js";
import { Views } from "./views.js";

const NO_WEBGL =
  "WebGL 2 is not available, so the solids cannot be drawn; curves and time controls work.";
/** Minimum width of a page that shows a panel initially [px]. */
const ROOM = 900;

export class Page {
  /** @param {HTMLElement} root @param {any[]} scenes one, or two that are compared */
  constructor(root, scenes) {
    this.root = root;
    this.scenes = scenes;
    this.last = 0;
    this.waiting = 0;
    this.stage = null;
    this.shared = sharedFrames(scenes);
    const { times } = this.shared;
    this.poses = new Poses(scenes[0]);
    this.player = new Player(times, this.poses);
    const marks = allMarks(scenes);
    const range = [this.player.first, this.player.last];
    this.curves = new Curves(scenes, range, marks, (t) => this.seek(t));
    this.transport = new Transport(this.player, marks, {
      seek: (t) => this.seek(t),
      toggle: () => this.toggle(),
      step: (n) => this.step(n),
      speed: (x) => (this.player.speed = x),
      loop: (what) => this.loop(what),
    }, this.shared.whose);
    this.panels = new Panels();
    this.host = el("div", { className: "ppv-view" });
    this.area = el("div", { className: "ppv-scene" }, this.host, this.panels.panel);
    const title = [...new Set(scenes.map((scene) => scene.title))].join(" and "),
      subtitle = scenes.length > 1 ? "" : scenes[0].subtitle;
    const head = el(
      "div",
      { className: "ppv-head" },
      el(
        "div",
        { className: "ppv-title", title: `${title} ${subtitle}` },
        el("b", {}, title),
        el("span", {}, subtitle),
      ),
      this.panels.bar,
    );
    this.transport.row.append(this.curves.bar);
    root.replaceChildren(head, this.area, this.transport.element, this.curves.element);
    this.#scene();
    this.#panels();
    keys(this);
    this.watch = new ResizeObserver(() => this.resize());
    this.watch.observe(root);
    this.watch.observe(this.curves.body);
    // WebGL clears the canvas after each frame; printing requires a new one.
    window.addEventListener("beforeprint", () => this.draw());
    this.dark = window.matchMedia("(prefers-color-scheme: dark)");
    this.dark.addEventListener("change", () => this.colours());
    this.resize();
    this.curves.build();
    this.colours();
  }

  #announce(words) {
    this.area.append(el("div", { className: "ppv-message", role: "alert" }, el("p", {}, words)));
  }

  #scene() {
    if (!this.scenes.some((scene) => scene.solids.length)) {
      this.#announce("This scene contains no solids: the model defines no geometry, or the result does not contain it.");
      return;
    }
    const found = graphics();
    if (!found) {
      this.#announce(NO_WEBGL);
      return;
    }
    this.stage = new Stage(this.host, this.scenes, found.software);
    const { stage } = this;
    stage.canvas.tabIndex = 0;
    stage.canvas.setAttribute("aria-label", "3-D scene: drag to rotate, right button to pan, wheel to zoom");
    stage.canvas.addEventListener("webglcontextlost", () =>
      this.#announce("The graphics context was lost. Reload the page."),
    );
    this.orbit = new Orbit(stage.camera, stage.canvas, () => this.changed(), this.scenes[0].up);
    // On a longer page the wheel scrolls the page until the user clicks the scene.
    this.orbit.takesWheel = (event) => {
      const takes = this.fills || event.ctrlKey || document.activeElement === stage.canvas;
      if (!takes) this.hint("click the scene to zoom with the wheel");
      return takes;
    };
    touches(this);
    this.orbit.pictures = stage.pictures.length;
    const { radius } = stage.bounds();
    this.orbit.nearest = 2e-5 * radius;
    this.orbit.farthest = 40 * radius;
    this.views = new Views(stage, this.orbit, () => this.legends, () => (this.scenes[1] ? 0 : this.panels.share));
    this.hover = new Hover(stage, this.orbit, (name) => this.follow(this.views.names.indexOf(name)));
    this.legends = stage.pictures.map(({ arrows }) => new Legend(arrows.arrows));
    this.boxes = stage.pictures.map(({ flanks }) => new FlankBox(flanks));
    this.scales = stage.pictures.map(() =>
      el("div", { className: "ppv-scale", "aria-hidden": "true" }, el("span"), el("i"), el("span"), el("b")),
    );
    this.status = el("div", { className: "ppv-status", role: "status" });
    const names = namesOf(this.scenes);
    this.names = names.map((name, k) =>
      name && el("span", { className: "ppv-name", title: this.scenes[k].label }, el("span", {}, name), el("span", {})),
    );
    const halves = this.legends.map((legend, k) =>
      el(
        "div",
        { className: "ppv-half" },
        legend.element,
        this.boxes[k].element,
        this.names[k],
        this.scales[k],
      ),
    );
    this.host.append(
      el("div", { className: "ppv-halves" }, ...halves),
      this.hover.label,
      this.status,
    );
  }

  #panels() {
    const { panels, stage } = this;
    if (stage) {
      panels.action("Fit", "Fit all (f)", () => this.views.fit());
      panels.add("View", "Standard views, followed body, housing, view into a mesh", viewRows(this));
      if (this.scenes.some((scene) => scene.arrows.length))
        panels.add("Forces", "Force arrows", forceRows(this));
      if (this.scenes.some((scene) => scene.contacts.length))
        panels.add("Flanks", "Contact lines, pattern and gap of the teeth", flankRows(this));
      if (this.player.times.length > 1) panels.add("Vibration", "Magnify vibrations", vibrationRows(this));
      this.section = new SectionView(stage, () => this.changed());
      panels.add("Section", "Section plane through the solids", this.section.rows);
      const { modes } = this.scenes[0];
      if (modes.length && !this.scenes[1]) {
        this.modes = new Modes(modes, stage, () => this.changed());
        const opener = panels.add("Modes", "Mode shapes", this.modes.rows);
        // On a page without a record, mode shapes are the only animation.
        if (this.player.times.length < 2 && this.host.clientWidth >= ROOM) panels.show("Modes", this.modes.rows, opener);
      }
      panels.add("Save", "Picture, solids, video", saveRows(this));
    }
    if (this.transport.marks.length)
      panels.add("Marks", "Events in the record", markRows(this));
    const notes = [...new Set([this.shared.note, ...this.scenes.flatMap((scene) => scene.notes)])].filter(Boolean);
    const help = [el("dl", {}, ...KEYS.flatMap(([key, what]) => [el("dt", {}, key), el("dd", {}, what)]))];
    if (notes.length)
      help.unshift(el("ul", { className: "ppv-notes" }, ...notes.map((note) => el("li", {}, note))));
    panels.add(notes.length ? `Notes (${notes.length})` : "?", "Notes and keyboard shortcuts", help);
  }

  /** Colours drawn by scripts follow the colour scheme of the page. */
  colours() {
    this.stage?.background.set(getComputedStyle(this.area).backgroundColor);
    this.curves.build();
    this.transport.draw();
    this.changed();
  }

  resize() {
    if (!this.root.clientWidth || !this.root.clientHeight) return;
    if (this.stage) {
      const first = this.stage.size.width === 1;
      this.stage.resize();
      // The area covered by the legends is known only after they are filled.
      if (first) this.draw();
      for (const legend of this.legends) legend.settle();
      if (first) this.views.named("iso", true);
      if (!this.orbit.chosen) this.views.fit(true);
      this.draw();
    }
    this.curves.resize();
    this.transport.draw();
    this.update();
  }

  /** Request one redraw at the next frame of the browser. */
  changed() {
    if (!this.waiting) this.waiting = requestAnimationFrame((now) => this.#frame(now));
  }

  #frame(now) {
    this.waiting = 0;
    const moving = this.player.playing || this.easing || this.modes?.active;
    const dt = moving && this.last ? Math.min(0.25, Math.max(0, (now - this.last) / 1000)) : 1 / 60;
    this.last = now;
    this.player.advance(dt);
    this.modes?.advance(dt);
    this.easing = this.orbit?.step(dt) ?? false;
    this.#spare(dt, moving);
    this.update();
    this.draw();
    this.frames = (this.frames ?? 0) + 1;
    if (this.player.playing || this.easing || this.modes?.active) this.changed();
    else this.last = 0;
  }

  /** Below about twelve frames per second the resolution is reduced in favour of smooth motion. */
  #spare(dt, moving) {
    const goesOn = this.player.playing || this.easing || this.modes?.active;
    if (moving && goesOn) this.pace = 0.7 * (this.pace ?? dt) + 0.3 * dt;
    // The resolution of a video cannot change during the recording.
    if (this.filming) return;
    this.stage?.coarsen(Boolean(goesOn) && this.pace > (this.stage.coarse ? 0.03 : 0.085));
  }

  /** Update all elements except the scene. */
  update() {
    this.transport.update();
    this.curves.cursor(this.player.time);
    this.#sendTime();
  }

  /** Report the current time to the surrounding page. */
  #sendTime() {
    if (this.player.time === this.sent) return;
    this.sent = this.player.time;
    this.#announceEnds();
    this.root.dispatchEvent(new CustomEvent("pp-time", { bubbles: true, detail: this.sent }));
  }

  /** Mark a result whose record has ended; its bodies remain at rest. */
  #announceEnds() {
    if (this.scenes.length < 2 || !this.names) return;
    this.names.forEach((node, k) => {
      const end = this.scenes[k].times?.data.at(-1);
      const text = ended(end, this.sent) ? ` (ended at ${duration(end)})` : "";
      if (node && node.lastChild.textContent !== text) node.lastChild.textContent = text;
    });
  }

  draw() {
    const { stage, orbit } = this;
    if (!stage || stage.size.width === 1) return;
    for (const picture of stage.pictures) {
      if (this.modes?.active) this.modes.pose(picture);
      else picture.poses.at(this.player.time);
    }
    if (!this.modes?.active) this.views.update();
    this.section?.update();
    stage.pictures.forEach((picture, k) => {
      const pixel = picture.factor * orbit.pixel;
      picture.solids.update(0.25 * pixel);
      picture.arrows.hidden = picture.flanks.hidden = Boolean(this.modes?.active);
      picture.flanks.look();
      const removed = (point) => Boolean(this.section?.on) && this.section.removes(point, k);
      picture.flanks.update(pixel, removed);
      picture.arrows.update(pixel, (point) => ({ ...stage.onScreen(point, k), removed: removed(point) }));
    });
    stage.render(orbit);
    stage.pictures.forEach(({ arrows }, k) =>
      this.legends[k].update(arrows.now, arrows.shown, arrows.hidden),
    );
    for (const box of this.boxes) box.update();
    this.#scaleBar();
  }

  #scaleBar() {
    const { alike, pictures } = this.stage;
    const wide = this.host.clientWidth / pictures.length < 300 ? 60 : 90;
    this.scales.forEach((scale, k) => {
      const pixel = pictures[k].factor * this.orbit.pixel;
      const size = round125(wide * pixel);
      const [text, bar, words, arrow] = scale.children;
      scale.hidden = alike && k > 0;
      text.textContent = length(size);
      bar.style.width = `${size / pixel}px`;
      const { perForce = 0, size: largest, hidden } = pictures[k].arrows;
      const load = perForce > 0 ? round125((wide * pixel) / perForce) : 0;
      // far away, arrows are too short for a scale
      words.hidden = arrow.hidden = hidden || !(load > 0 && load <= 2 * largest);
      if (arrow.hidden) return;
      words.textContent = force(load, "N").replace(/\.0+(?=\D)/, "");
      arrow.style.width = `${(load * perForce) / pixel}px`;
    });
    const { body, names } = this.views;
    const following = body >= 0 ? `following ${names[body]}` : "";
    const larger =
      this.stage.pictures[0].poses.magnification > 1
        ? `vibrations × ${this.magnification.row.lastChild.textContent}`
        : "";
    this.status.textContent = [following, larger, this.modes?.words].filter(Boolean).join(" · ");
  }

  /** Whether the viewer fills the page. */
  get fills() {
    return this.root.clientHeight > 0.8 * window.innerHeight;
  }

  /**
   * Change the tables of the scene at the pace of a running model; arrows keep the scale of the largest force so far.
   * @param {(scene: any) => void} change
   */
  live(change) {
    change(this.scenes[0]);
    for (const { arrows } of this.stage?.pictures ?? []) arrows.grow();
    this.changed();
  }

  /** @param {string} words message, shown temporarily */
  hint(words) {
    this.status.textContent = words;
    clearTimeout(this.hinted);
    this.hinted = setTimeout(() => this.changed(), 2500);
  }

  /** Advance by a time step as a browser frame does. @param {number} dt real time [s] */
  advance(dt) {
    this.player.advance(dt);
    this.modes?.advance(dt);
    this.update();
    this.draw();
  }

  /** @param {number} t [s] */
  seek(t) {
    this.player.seek(t);
    this.update();
    this.changed();
  }

  toggle(on = !this.player.playing) {
    this.player.playing = on && this.player.last > this.player.first;
    this.transport.update();
    this.changed();
  }

  /** @param {number} frames */
  step(frames) {
    this.player.step(frames);
    this.update();
    this.changed();
  }

  /** @param {string} what @returns {string} error message, empty if there is none */
  loop(what) {
    const wrong = this.player.repeat(what, this.views?.first ?? -1, this.scenes[0].solids);
    this.transport.loop.select.value = this.player.loop;
    this.transport.draw();
    this.changed();
    return wrong;
  }

  /** Parallel or central projection. @param {boolean} parallel */
  project(parallel) {
    if (!this.stage) return;
    this.stage.parallel = parallel;
    this.parallel.input.checked = parallel;
    if (!this.orbit.chosen) this.views.fit(true);
    this.changed();
  }

  /** @param {number} body index in the list of bodies to follow, -1 none */
  follow(body) {
    if (!this.stage || body >= this.views.names.length) return;
    this.views.follow(body);
    if (body >= 0) this.views.closeUp();
    this.followed.select.value = String(body);
    this.changed();
  }

  /** @param {number} times */
  magnify(times) {
    for (const picture of this.stage.pictures) picture.poses.magnification = times;
    this.changed();
  }

  /** @param {string} kind @param {boolean} on */
  arrows(kind, on) {
    for (const { arrows } of this.stage.pictures) on ? arrows.shown.add(kind) : arrows.shown.delete(kind);
    if (this.kinds?.[kind]) this.kinds[kind].input.checked = on;
    this.changed();
  }

  /** All arrows, or only those that do not clutter the picture. @param {boolean} sparse */
  density(sparse) {
    for (const { arrows } of this.stage.pictures) arrows.sparse = sparse;
    if (this.sparse) this.sparse.input.checked = sparse;
    this.changed();
  }

  /** @param {any} arrow of a mesh */
  intoMesh(arrow) {
    const found = this.views.intoMesh(arrow);
    this.section.through(
      found.map((each) => each?.point),
      found.find(Boolean).axis,
    );
  }
}

/** Marks of all results; marks of two results include the name of the result. @param {any[]} scenes */
function allMarks(scenes) {
  const names = namesOf(scenes);
  return scenes.flatMap((scene, k) =>
    scene.marks.map((mark) => ({ ...mark, what: [mark.what, names[k]].filter(Boolean).join(", ") })),
  );
}
