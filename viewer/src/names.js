// SPDX-License-Identifier: Apache-2.0
// Short and distinct names of two results that are compared.

const LONGEST = 36;

/**
 * Names that distinguish two results; empty for a single result.
 * @param {any[]} scenes
 * @returns {string[]}
 */
export function namesOf(scenes) {
  if (scenes.length < 2) return [""];
  for (const key of ["title", "label", "subtitle"]) {
    const [first, second] = scenes.map((scene) => scene[key] ?? "");
    if (first && second && first !== second) return apart(first, second);
  }
  return ["first", "second"];
}

/**
 * Two different texts; long texts are reduced to the parts that differ.
 * @param {string} first
 * @param {string} second
 * @returns {string[]}
 */
export function apart(first, second) {
  if (Math.max(first.length, second.length) <= LONGEST) return [first, second];
  const words = [first, second].map((text) => text.split(/(?<=[\s,_/-])/));
  let same = 0;
  while (same < Math.min(words[0].length, words[1].length) - 1 && words[0][same] === words[1][same]) same++;
  return words.map((each) => {
    const rest = (same ? "… " : "") + each.slice(same).join("");
    return rest.length > LONGEST ? `${rest.slice(0, LONGEST - 1).trimEnd()}…` : rest;
  });
}
