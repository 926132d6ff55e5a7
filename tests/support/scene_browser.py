# SPDX-License-Identifier: Apache-2.0
"""Runs scripts of tests in a page with scenes, in a headless browser that draws in software."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from tests.support.chromium import BROWSER, SOFTWARE_3D, chromium
from tests.support.scene_data import page_of

__all__ = ["BROWSER", "STATES", "about_z", "fine", "matrix", "probed"]

FOUND = 'document.getElementById("found")?.textContent'

# errors of scripts and of the policy end in the page, where a test reads them
LISTEN = """
  const errors = [];
  addEventListener("error", (event) => errors.push(String(event.message)));
  addEventListener("unhandledrejection", (event) => errors.push(String(event.reason)));
  addEventListener("securitypolicyviolation", (event) => errors.push("policy: " + event.violatedDirective));
  for (const name of ["error", "warn"]) console[name] = (...words) => errors.push(words.join(" "));
"""
PROBE = """
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const until = async (holds) => { for (let k = 0; k < 300 && !holds(); k++) await wait(50); };
  const press = (key, on = document.body) => on.dispatchEvent(new KeyboardEvent("keydown", {key,
    bubbles: true, cancelable: true}));
  const V = pitchpointViewer, S = () => V.state(), $ = (what) => document.querySelector(what);
  const named = (text) => [...document.querySelectorAll(".ppv-tools button")].find((b) =>
    b.textContent === text);
  mounted.then(async (fine) => {
    const say = (found) => { $("#found").textContent = JSON.stringify({fine, errors, found}); };
    try { say(await (async () => { %s })()); } catch (error) { errors.push(String(error.stack));
    say(null); }
  });
"""


STATES = "const out = []; for (const t of %s) { V.seek(t); V.draw(); out.push(S()); } return out;"


def probed(
    tmp_path: Path,
    script: str,
    *texts: tuple[str, str],
    flags: tuple[str, ...] = (),
    size: str = "1000px;height:650px",
) -> dict[str, Any]:
    """What a script of the test finds in a page with scenes."""
    page = tmp_path / "scene.html"
    page.write_text(page_of(*texts, before=LISTEN, script=PROBE % script, size=size), encoding="utf-8")
    said = chromium(*SOFTWARE_3D, *flags).show(page, FOUND, budget=60_000, wait=False)
    assert said, "the script of the test has said nothing"
    return dict(json.loads(said))


def fine(found: dict[str, Any]) -> Any:
    assert found["errors"] == [] and found["fine"]
    return found["found"]


def matrix(elements: list[float]) -> np.ndarray:
    """A matrix of the viewer, which counts by columns."""
    return np.array(elements).reshape(4, 4).T


def about_z(angle: float) -> np.ndarray:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
