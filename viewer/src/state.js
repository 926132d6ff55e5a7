// SPDX-License-Identifier: Apache-2.0
// State of the viewer as plain numbers, for tests and for pages that control the viewer.
import { Vector3 } from "three";

/** @param {import("./page.js").Page} page */
export function stateOf(page) {
  const { player, stage, curves } = page;
  const triple = (v) => [v.x, v.y, v.z];
  return {
    time: player.time,
    playing: player.playing,
    frame: player.frame,
    speed: player.speed,
    loop: player.loop,
    window: [...player.window],
    channels: [...curves.plots.names],
    cursor: curves.plots.drawn.map(({ plot, line }) => ({
      at: line.hidden ? null : plot.posToVal(new DOMMatrix(getComputedStyle(line).transform).m41, "x"),
      readings: [...line.closest(".ppv-plot").querySelectorAll("output")].map((node) => node.textContent),
    })),
    spectrum: curves.spectra.state(),
    marks: page.transport.marks.length,
    message: page.area.querySelector(".ppv-message")?.textContent ?? null,
    drawn: stage?.drawn ?? 0,
    ratio: stage?.ratio ?? 0,
    projection: stage?.parallel ? "parallel" : "central",
    section: page.section
      ? { on: page.section.on, normal: triple(page.section.normal), at: page.section.at }
      : null,
    mode: page.modes?.number ?? -1,
    following: page.views?.body ?? -1,
    camera: page.orbit
      ? {
          position: triple(stage.camera.position),
          target: triple(page.orbit.now.target),
          distance: page.orbit.now.distance,
          near: stage.camera.near,
          far: stage.camera.far,
        }
      : null,
    pictures: (stage?.pictures ?? []).map((picture) => ({
      bodies: picture.poses.world.map((matrix) => [...matrix.elements]),
      seen: [...picture.seen.elements],
      factor: picture.factor,
      target: triple(stage.targetOf(picture, page.orbit.now.target)),
      magnification: picture.poses.magnification,
      triangles: picture.solids.triangles,
      drawnTriangles: picture.solids.drawn,
      batches: picture.solids.batches.length,
      hatches: page.section?.on ? picture.caps.state() : {},
      contacts: picture.flanks.state(),
      arrows: (picture.arrows.now ?? []).map((force, k) => ({
        name: force.name,
        kind: force.kind,
        state: force.state,
        at: triple(force.at),
        vectors: Object.fromEntries(
          Object.entries(force.vectors).map(([part, vector]) => [part, triple(vector)]),
        ),
        lengths: Object.fromEntries(
          Object.entries(picture.arrows.drawn[k].parts).map(([part, mesh]) => [
            part,
            mesh.visible ? new Vector3().setFromMatrixColumn(mesh.matrix, 2).length() : 0,
          ]),
        ),
      })),
    })),
  };
}
