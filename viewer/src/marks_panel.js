// SPDX-License-Identifier: Apache-2.0
// List of event marks with time, kind and object; a click sets the time to that of the event.
import { button, el } from "./dom.js";
import { colourOfMark } from "./colours.js";
import { duration, instant } from "./numbers.js";

const NAMES = {
  contact_loss: "contact loss",
  impact: "impact",
  back_flank: "contact on back flank",
  front_flank: "contact on front flank",
  faulty_tooth: "faulty tooth in mesh",
};
const MOST = 400;

/** @param {string} kind */
export const nameOfMark = (kind) => NAMES[kind] ?? kind.replaceAll("_", " ");

/** Rows of the panel "Marks". @param {import("./page.js").Page} page */
export function markRows(page) {
  const { marks, kinds, stepLength } = page.transport;
  const off = new Set();
  const list = el("div", { className: "ppv-marklist" });
  const fill = () => {
    const shown = marks.filter((mark) => !off.has(mark.kind));
    list.replaceChildren(
      ...shown.slice(0, MOST).map((mark) => {
        const when = instant(mark.time, stepLength / 10);
        const lasts = mark.until > mark.time ? `, ${duration(mark.until - mark.time)}` : "";
        const row = button("", `Go to ${nameOfMark(mark.kind)} at ${when}`, () => page.seek(mark.time));
        row.append(
          el("i", { style: `background:${colourOfMark(kinds, mark.kind)}` }),
          el("b", {}, when),
          el("span", {}, `${nameOfMark(mark.kind)}${mark.what ? `, ${mark.what}` : ""}${lasts}`),
        );
        return row;
      }),
      shown.length > MOST ? el("p", { className: "ppv-soft" }, `${shown.length - MOST} more`) : "",
    );
  };
  const ticks = kinds.map((kind) => {
    const count = marks.filter((mark) => mark.kind === kind).length;
    const box = el("input", {
      type: "checkbox",
      checked: true,
      onchange: () => {
        box.checked ? off.delete(kind) : off.add(kind);
        fill();
      },
    });
    return el(
      "label",
      { className: "ppv-tick" },
      box,
      el("i", { className: "ppv-dot", style: `background:${colourOfMark(kinds, kind)}` }),
      el("span", {}, `${nameOfMark(kind)} (${count})`),
    );
  });
  fill();
  return [...ticks, list];
}
