# SPDX-License-Identifier: Apache-2.0
"""The scene of a notebook in a browser: it draws inside its sandbox, and no console hears of it."""

from __future__ import annotations

import html
import json
import re
import subprocess
from pathlib import Path

import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.notebook import model_html
from tests.support.model_files import TORSIONAL_PAIR
from tests.support.scene_browser import BROWSER

pytestmark = pytest.mark.skipif(
    BROWSER is None, reason="no Chromium on this machine; install chromium to run it"
)

# within the frame: what the viewer says of itself, told to the page around it as soon as there is a scene
TELL = """<script>
const errors = [];
addEventListener("error", (event) => errors.push(String(event.message)));
addEventListener("securitypolicyviolation", (event) => errors.push("policy: " + event.violatedDirective));
(async () => {
  for (let k = 0; k < 300 && !(window.pitchpointViewer && pitchpointViewer.state()?.pictures); k++)
    await new Promise((done) => setTimeout(done, 50));
  const state = window.pitchpointViewer ? pitchpointViewer.state() : null;
  parent.postMessage(JSON.stringify({errors, state, origin: self.origin}), "*");
})();
</script>"""
HEAR = """<pre id="found"></pre><script>
addEventListener("message", (event) => { document.getElementById("found").textContent = event.data; });
</script>"""


def test_a_model_in_a_cell(tmp_path: Path) -> None:
    assert BROWSER is not None
    text = model_html(loads_model(TORSIONAL_PAIR))
    told, count = re.subn(r"&lt;body&gt;", lambda m: m.group() + html.escape(TELL), text, count=1)
    assert count == 1
    page = tmp_path / "cell.html"
    page.write_text(f'<!DOCTYPE html><meta charset="utf-8">{HEAR}{told}', encoding="utf-8")
    command = [
        BROWSER,
        *"--headless --no-sandbox --disable-quic --no-first-run --disable-extensions".split(),
        *"--disable-background-networking --disable-component-update --disable-sync".split(),
        *"--use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader".split(),
        # virtual time waits for frames of its own process only
        "--disable-features=IsolateSandboxedIframes",
        "--enable-logging=stderr",
        f"--user-data-dir={tmp_path / 'profile'}",
        "--virtual-time-budget=60000",
        "--window-size=1000,900",
        "--dump-dom",
        page.as_uri(),
    ]
    done = subprocess.run(command, capture_output=True, text=True, timeout=180, check=True)
    assert not [line for line in done.stderr.splitlines() if "CONSOLE" in line]
    match = re.search(r'<pre id="found">(.+?)</pre>', done.stdout, re.DOTALL)
    assert match, done.stdout[-1000:]
    found = json.loads(html.unescape(match.group(1)))
    assert found["errors"] == []
    assert found["origin"] == "null"  # the sandbox is there: the frame belongs to nobody
    assert found["state"]["message"] is None
    assert len(found["state"]["pictures"][0]["bodies"]) == 2
