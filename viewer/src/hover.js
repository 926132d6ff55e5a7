// SPDX-License-Identifier: Apache-2.0
// The name of the part under the pointer; a double click follows its body.
import { el } from "./dom.js";

const TAP = 8; // maximum travel of a finger during a tap [px]

export class Hover {
  /**
   * @param {import("./stage.js").Stage} stage
   * @param {import("./orbit.js").Orbit} orbit
   * @param {(body: string) => void} follow
   */
  constructor(stage, orbit, follow) {
    this.stage = stage;
    this.label = el("div", { className: "ppv-label", hidden: true });
    this.at = null;
    this.waiting = false;
    const { canvas } = stage;
    canvas.addEventListener("pointermove", (event) => {
      this.at =
        orbit.dragging || event.pointerType === "touch" ? null : { x: event.clientX, y: event.clientY };
      // Ray casting on 30 000 triangles takes milliseconds: at most one ray per 60 ms is cast.
      if (!this.waiting) setTimeout(() => this.#look(), 60);
      this.waiting = true;
    });
    canvas.addEventListener("pointerleave", (event) => {
      this.at = null;
      if (event.pointerType !== "touch") this.label.hidden = true;
    });
    // Touch screens have no hovering: a tap shows the name until the next touch.
    let down = { x: 0, y: 0 };
    canvas.addEventListener("pointerdown", ({ clientX: x, clientY: y, pointerType }) => {
      down = { x, y };
      if (pointerType === "touch") this.label.hidden = true;
    });
    canvas.addEventListener("pointerup", ({ clientX: x, clientY: y, pointerType }) => {
      if (pointerType !== "touch" || Math.hypot(x - down.x, y - down.y) > TAP) return;
      this.at = { x, y };
      this.#look();
      this.at = null;
    });
    canvas.addEventListener("dblclick", (event) => {
      const found = stage.hit(event.clientX, event.clientY);
      if (!found) return;
      const { bodies } = stage.pictures[found.picture].data;
      let body = bodies[found.part.solid.body];
      // Cages are not in the list of bodies; the ring that they run in is.
      while (body?.part) body = bodies[body.parent];
      follow(body?.name);
    });
  }

  #look() {
    this.waiting = false;
    const found = this.at && this.stage.hit(this.at.x, this.at.y);
    this.label.hidden = !found;
    if (!found) return;
    const { solid } = found.part;
    this.label.textContent = words(solid, found.fault);
    const box = this.stage.canvas.getBoundingClientRect();
    const x = Math.min(this.at.x - box.left + 14, box.width - this.label.offsetWidth - 4);
    this.label.style.transform = `translate(${x}px, ${Math.max(0, this.at.y - box.top - 26)}px)`;
  }
}

/** @param {any} solid @param {string} fault of the piece */
export function words(solid, fault = "") {
  const { name } = solid;
  if (solid.kind === "element" || (fault && !solid.teeth)) return fault ? `${name}, ${fault}` : name;
  return solid.teeth
    ? `${name}, ${solid.kind}, ${solid.teeth} teeth`
    : name === solid.kind
      ? name
      : `${name}, ${solid.kind}`;
}
