// SPDX-License-Identifier: Apache-2.0
// Fingers: within a longer page one that goes up or down scrolls the page until the scene has been tapped.

/** @param {import("./page.js").Page} page */
export function touches(page) {
  const { canvas } = page.stage;
  const set = () => {
    canvas.style.touchAction = page.fills || document.activeElement === canvas ? "none" : "pan-y";
  };
  for (const name of ["focus", "blur", "pointerenter"]) canvas.addEventListener(name, set);
  window.addEventListener("resize", set);
  set();
}
