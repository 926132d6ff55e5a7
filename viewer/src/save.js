// SPDX-License-Identifier: Apache-2.0
// Export of files: picture, solids, animated solids, video.
import { Matrix4, Vector3 } from "three";
import { el } from "./dom.js";
import { glb } from "./glb.js";
import { colourOfForce } from "./colours.js";
import { loadColour } from "./load_colours.js";
import { instant } from "./numbers.js";
import { mergedPoints } from "./merged_points.js";

/** @param {Blob} blob @param {string} name */
export function download(blob, name) {
  const address = URL.createObjectURL(blob);
  const link = el("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 60000);
}

/** File name from the title of the scene. @param {import("./page.js").Page} page @param {string} ending */
export function fileName(page, ending) {
  const plain = page.scenes[0].title
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "");
  return `${plain || "scene"}.${ending}`;
}

/**
 * Picture of the current scene with title, time and forces.
 * @param {import("./page.js").Page} page
 * @param {number} times factor of the resolution
 * @returns {Blob}
 */
export function png(page, times = 1) {
  const { stage } = page;
  const { renderer, canvas } = stage;
  renderer.setPixelRatio(stage.ratio * times);
  renderer.setSize(stage.size.width, stage.size.height);
  page.draw();
  const paper = el("canvas", { width: canvas.width, height: canvas.height });
  const pen = paper.getContext("2d");
  // The content of a WebGL canvas is lost after the frame; it is copied immediately.
  pen.drawImage(canvas, 0, 0);
  stage.resize();
  page.draw();
  const k = stage.ratio * times;
  pen.scale(k, k);
  const style = getComputedStyle(page.root);
  const ink = style.getPropertyValue("--v-ink").trim() || "#222",
    soft = style.getPropertyValue("--v-soft").trim() || "#666";
  const { width, height } = stage.size;
  pen.textBaseline = "top";
  pen.font = `600 14px ${style.fontFamily}`;
  pen.fillStyle = ink;
  const each = width / page.scenes.length;
  const written = page.scenes.map((scene, n) => {
    const title = cut(pen, [scene.title, scene.label].filter(Boolean).join(", "), each - 24);
    pen.fillText(title, 12 + n * each, 10);
    return pen.measureText(title).width + 24;
  });
  pen.font = `12px ${style.fontFamily}`;
  pen.fillStyle = soft;
  const when = page.modes?.active
    ? page.modes.words
    : `t = ${instant(page.player.time, page.transport.stepLength / 10)}`;
  page.scenes.forEach((scene, n) =>
    pen.fillText(cut(pen, [scene.subtitle, when].filter(Boolean).join(", "), each - 24), 12 + n * each, 28),
  );
  page.legends.forEach((shown, n) => {
    if (!shown.element.hidden) legend(pen, page, n, { right: (n + 1) * each, room: each - written[n] }, ink, style);
  });
  page.boxes.forEach((box, n) => {
    if (!box.element.hidden) loads(pen, box, { x: 12 + n * each, y: height - 62, room: each - 24 }, soft);
  });
  pen.fillStyle = pen.strokeStyle = soft;
  page.scales.forEach((scale, n) => {
    if (!scale.hidden) ruler(pen, scale, 12 + n * each, height);
  });
  const bytes = atob(paper.toDataURL("image/png").split(",")[1]);
  return new Blob([Uint8Array.from(bytes, (letter) => letter.charCodeAt(0))], { type: "image/png" });
}

/** Scale bar at the lower edge. */
function ruler(pen, scale, x, height) {
  const [text, bar] = scale.children;
  const length = parseFloat(bar.style.width);
  pen.fillText(text.textContent, x, height - 30);
  pen.beginPath();
  pen.moveTo(x, height - 15);
  pen.lineTo(x, height - 10);
  pen.lineTo(x + length, height - 10);
  pen.lineTo(x + length, height - 15);
  pen.stroke();
  const [, , force, arrow] = scale.children;
  if (arrow.hidden) return;
  const from = x + Math.max(length, pen.measureText(text.textContent).width) + 14;
  const to = from + parseFloat(arrow.style.width);
  pen.fillText(force.textContent, from, height - 30);
  pen.beginPath();
  pen.moveTo(from, height - 12);
  pen.lineTo(to, height - 12);
  for (const side of [-4, 4]) {
    pen.moveTo(to, height - 12);
    pen.lineTo(to - 7, height - 12 + side);
  }
  pen.stroke();
}

/** Colour scale of the flanks and text of the gap, above the scale bar. */
function loads(pen, box, { x, y, room }, soft) {
  pen.fillStyle = soft;
  pen.font = pen.font.replace(/^\d+px/, "11px");
  if (!box.bar.hidden) {
    for (let k = 0; k < 210; k++) {
      pen.fillStyle = `rgb(${loadColour(k / 209).map((part) => Math.round(255 * part)).join(" ")})`;
      pen.fillRect(x + k, y, 1.5, 8);
    }
    pen.fillStyle = soft;
    const words = `${box.what.textContent}: 0 … ${box.end.textContent}, ${box.now.textContent}`;
    pen.fillText(cut(pen, words, room), x, y + 11);
  }
  if (box.gap.hidden) return;
  const lines = wrapped(pen, box.gap.textContent, room);
  lines.forEach((line, k) => pen.fillText(line, x, y - 16 - 14 * (lines.length - 1 - k)));
}

/**
 * Lines of a text that fit the available width.
 * @param {CanvasRenderingContext2D} pen
 * @param {string} text
 * @param {number} room [px]
 */
function wrapped(pen, text, room) {
  const lines = [""];
  for (const word of text.split(" ")) {
    const longer = lines.at(-1) ? `${lines.at(-1)} ${word}` : word;
    if (lines.at(-1) && pen.measureText(longer).width > room) lines.push(word);
    else lines[lines.length - 1] = longer;
  }
  return lines;
}

/**
 * A text truncated to the available width.
 * @param {CanvasRenderingContext2D} pen
 * @param {string} text
 * @param {number} room [px]
 */
function cut(pen, text, room) {
  if (pen.measureText(text).width <= room) return text;
  let end = text.length;
  while (end > 1 && pen.measureText(`${text.slice(0, end)}…`).width > room) end--;
  return `${text.slice(0, end).trimEnd()}…`;
}

/**
 * Table of forces at the right edge, without rows if it is folded, and below the title if the width does not
 * suffice.
 */
function legend(pen, page, n, { right: width, room }, ink, style) {
  const { arrows } = page.stage.pictures[n];
  const shown = page.legends[n];
  const { columns } = shown;
  const lines = shown.folded ? [] : shown.lines(arrows.now, arrows.shown).slice(0, 20);
  const wide =
    92 * columns.length + 24 + Math.max(0, ...lines.map(({ name }) => pen.measureText(name).width));
  const top = wide > room ? 44 : 0;
  pen.globalAlpha = 0.85;
  pen.fillStyle = style.getPropertyValue("--v-paper").trim() || "#fff";
  pen.fillRect(width - wide, top, wide, 34 + 16 * lines.length);
  pen.globalAlpha = 1;
  pen.textAlign = "right";
  columns.forEach((part, c) => {
    pen.fillStyle = colourOfForce(page.root, part);
    pen.fillText(part, width - 12 - 92 * (columns.length - 1 - c), top + 10);
  });
  lines.forEach(({ name, values }, row) => {
    const y = top + 27 + 16 * row;
    pen.fillStyle = ink;
    pen.font = `12px ${style.fontFamily}`;
    pen.fillText(name, width - 12 - 92 * columns.length, y);
    for (const { part, text } of values)
      pen.fillText(text, width - 12 - 92 * (columns.length - 1 - columns.indexOf(part)), y);
  });
  pen.textAlign = "left";
}

/** All solids in their current position as binary STL, in metres. @param {import("./page.js").Page} page */
export function stl(page) {
  const parts = page.stage.pictures[0].solids.exported(false).map(({ solid, geometry }) => {
    const points = geometry.attributes.position.array;
    return { solid, points, index: mergedPoints(points, geometry.index.array) };
  });
  const count = parts.reduce((sum, { index }) => sum + index.length / 3, 0);
  const bytes = new ArrayBuffer(84 + 50 * count);
  const view = new DataView(bytes);
  view.setUint32(80, count, true);
  let at = 84;
  const corners = [new Vector3(), new Vector3(), new Vector3()];
  const normal = new Vector3(),
    edge = new Vector3();
  const put = (v) => {
    for (const x of [v.x, v.y, v.z]) {
      view.setFloat32(at, x, true);
      at += 4;
    }
  };
  for (const { solid, points, index } of parts) {
    const matrix = page.stage.pictures[0].poses.ofSolid(solid);
    for (let k = 0; k < index.length; k += 3) {
      corners.forEach((corner, i) => corner.fromArray(points, 3 * index[k + i]).applyMatrix4(matrix));
      normal.subVectors(corners[1], corners[0]).cross(edge.subVectors(corners[2], corners[0])).normalize();
      put(normal);
      corners.forEach(put);
      at += 2;
    }
  }
  return new Blob([bytes], { type: "model/stl" });
}

const MOST_KEYS = 1000;

/** All solids with their motion over the record. @param {import("./page.js").Page} page */
export function movingSolids(page) {
  const { solids, poses, data } = page.stage.pictures[0];
  const n = poses.times.length;
  const step = Math.max(1, Math.ceil((n - 1) / (MOST_KEYS - 1)));
  const frames = [];
  for (let k = 0; k < n; k += step) frames.push(k);
  // glTF readers interpolate along the shortest rotation between two keys. Keys are added until no body
  // rotates by more than a quarter turn between them.
  const times = denser(
    frames.map((k) => poses.times[k]),
    poses,
  );
  const exported = solids.exported(true);
  const tracks = poses.world.map(() => []);
  for (const t of times) {
    poses.at(t);
    poses.world.forEach((matrix, k) => tracks[k].push(new Matrix4().copy(matrix)));
  }
  poses.at(page.player.time);
  page.changed();
  return new Blob([glb(exported, data.bodies, tracks, times)], { type: "model/gltf-binary" });
}

/**
 * Times with additional keys for fast rotation.
 * @param {number[]} times
 * @param {import("./poses.js").Poses} poses
 */
function denser(times, poses) {
  const angles = (t) => {
    poses.at(t);
    return poses.bodies.map((_, k) => poses.angle(k));
  };
  const out = [times[0]];
  let before = angles(times[0]);
  for (let k = 1; k < times.length && out.length < 8 * MOST_KEYS; k++) {
    const after = angles(times[k]);
    const most = Math.max(0, ...after.map((angle, b) => Math.abs(angle - before[b])));
    const parts = Math.min(64, Math.max(1, Math.ceil(most / (Math.PI / 2))));
    for (let p = 1; p <= parts; p++) out.push(times[k - 1] + ((times[k] - times[k - 1]) * p) / parts);
    before = after;
  }
  return out;
}

/**
 * Video recorder for the canvas; null if the browser does not support recording.
 * @param {HTMLCanvasElement} canvas
 */
export function film(canvas) {
  if (typeof MediaRecorder === "undefined" || !canvas.captureStream) return null;
  const kinds = [
    "video/mp4;codecs=avc1.42E01E",
    "video/webm;codecs=vp9",
    "video/webm;codecs=vp8",
    "video/webm",
  ];
  const type = kinds.find((kind) => MediaRecorder.isTypeSupported(kind));
  if (!type) return null;
  return {
    ending: type.slice(6, type.includes(";") ? type.indexOf(";") : undefined),
    start() {
      const recorder = new MediaRecorder(canvas.captureStream(30), {
        mimeType: type,
        videoBitsPerSecond: 6e6,
      });
      const pieces = [];
      recorder.ondataavailable = ({ data }) => data.size && pieces.push(data);
      recorder.start(500);
      return () =>
        new Promise((done) => {
          recorder.onstop = () => done(new Blob(pieces, { type: type.split(";")[0] }));
          recorder.stop();
        });
    },
  };
}
