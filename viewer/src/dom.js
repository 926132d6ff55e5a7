// SPDX-License-Identifier: Apache-2.0
// Constructors of page elements and controls.

/**
 * @param {string} tag
 * @param {Record<string, any>} properties attributes, event listeners (on…) or properties
 * @param {...(Node|string|null|undefined)} children
 * @returns {any}
 */
export function el(tag, properties = {}, ...children) {
  const node = document.createElement(tag);
  for (const [key, value] of Object.entries(properties)) {
    if (value === null || value === undefined || value === false) continue;
    if (key.startsWith("on")) node.addEventListener(key.slice(2), value);
    else if (key in node && key !== "list" && typeof value !== "string") node[key] = value;
    else node.setAttribute(key === "className" ? "class" : key, value === true ? "" : String(value));
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

/** A button whose purpose is given to the tooltip and to screen readers. */
export function button(text, title, onclick, properties = {}) {
  return el("button", { type: "button", title, "aria-label": title, onclick, ...properties }, text);
}

/**
 * A logarithmic slider with its value next to it.
 * @param {{label: string, title: string, least: number, most: number, value: number, show: (x: number) =>
 *   string, changed: (x: number) => void}} what
 */
export function logSlider({ label, title, least, most, value, show, changed }) {
  const span = Math.log(most / least);
  const output = el("output", {}, show(value));
  const input = el("input", { type: "range", min: "0", max: "1", step: "0.001", title, "aria-label": title });
  const valueOf = () => least * Math.exp(span * Number(input.value));
  const set = (x) => {
    input.value = String(Math.log(x / least) / span);
    output.textContent = input.ariaValueText = show(x);
  };
  input.addEventListener("input", () => {
    const x = valueOf();
    output.textContent = input.ariaValueText = show(x);
    changed(x);
  });
  set(value);
  return { row: el("label", { className: "ppv-slider" }, el("span", {}, label), input, output), set, input };
}

/**
 * @param {string} label
 * @param {[string, string][]} options value and text
 * @param {(value: string) => void} changed
 */
export function choice(label, options, changed, title = label) {
  const select = el(
    "select",
    { title, "aria-label": title, onchange: () => changed(select.value) },
    ...options.map(([value, text]) => el("option", { value }, text)),
  );
  return { row: el("label", { className: "ppv-choice" }, el("span", {}, label), select), select };
}

/** @param {string} label @param {boolean} on @param {(on: boolean) => void} changed */
export function tick(label, on, changed, mark = null) {
  const input = el("input", { type: "checkbox", checked: on, onchange: () => changed(input.checked) });
  return { row: el("label", { className: "ppv-tick" }, input, mark, el("span", {}, label)), input };
}
