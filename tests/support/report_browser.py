# SPDX-License-Identifier: Apache-2.0
"""Runs scripts of tests in a page of the project, in a headless browser, after all of it has been drawn."""

from __future__ import annotations

import html
import json
import re
import subprocess
from pathlib import Path
from typing import Any

from tests.support.scene_browser import BROWSER, LISTEN

SOFTWARE = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
NO_WEBGL = ("--disable-gpu", "--disable-3d-apis")
READY = """
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const until = async (holds) => { for (let k = 0; k < 400 && !holds(); k++) await wait(50); };
  const $ = (what) => document.querySelector(what), all = (what) => [...document.querySelectorAll(what)];
  (async () => {
    await until(() => document.documentElement.dataset.ready && (!$("#pp-view") || $(".ppv[data-ready]")));
    let found = null;
    try { found = await (async () => { %s })(); } catch (error) { errors.push(String(error.stack)); }
    $("#found").textContent = JSON.stringify({errors, found});
  })();
"""


def found(folder: Path, text: str, script: str, *flags: str) -> Any:
    """What a script of the test finds in a page, after everything has been drawn without an error."""
    assert BROWSER is not None
    page = folder / "report.html"
    text = text.replace("<style>", f"<script>{LISTEN}</script><style>", 1)
    probe = f"<pre id='found' hidden></pre><script>{READY % script}</script></body>"
    page.write_text(text.replace("</body>", probe), encoding="utf-8")
    command = [
        BROWSER,
        *"--headless --no-sandbox --disable-quic --no-first-run --disable-extensions".split(),
        *"--disable-background-networking --disable-component-update --disable-sync".split(),
        f"--user-data-dir={folder / 'profile'}",
        "--virtual-time-budget=60000",
        *flags,
    ]
    command += ["--dump-dom", page.as_uri()]
    dom = subprocess.run(command, capture_output=True, text=True, timeout=180, check=True).stdout
    match = re.search(r"<pre id=['\"]found['\"][^>]*>(.+?)</pre>", dom, re.DOTALL)
    assert match, dom[-2000:]
    answer = json.loads(html.unescape(match.group(1)))
    assert answer["errors"] == []
    return answer["found"]
