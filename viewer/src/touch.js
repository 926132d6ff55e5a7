// SPDX-License-Identifier: Apache-2.0
// Touch input: on a longer page, vertical swipes scroll the page until the user taps the scene.

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
