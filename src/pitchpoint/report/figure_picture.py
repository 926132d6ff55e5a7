# SPDX-License-Identifier: Apache-2.0
"""Plots as picture files: pages directly, SVG and PNG with the browser of the system."""

from __future__ import annotations

import base64
import json
import os
import struct
import zlib
from collections.abc import Collection, Iterable
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import unquote_to_bytes

from pitchpoint.core.errors import PitchpointError
from pitchpoint.report.browser import browser_program, open_page

if TYPE_CHECKING:
    import plotly.graph_objects as go

KINDS = {".html": "page", ".svg": "svg", ".png": "png"}
"""Kinds of picture files of plots by their extensions, see `io.target`."""
HEADER = 33
"""Length of the signature and the first chunk of a PNG file [bytes]."""
WIDTH = 1000
"""Width of SVG and PNG pictures [pixels]; a PNG has twice as many."""


def check_picture(
    path: str | os.PathLike[str],
    inputs: Iterable[str | os.PathLike[str]] = (),
    formats: Collection[str] = tuple(KINDS),
) -> Path:
    """Path of a picture; checks before a computation that it can be written.

    Parameters
    ----------
    path
        File to write; its extension is the format.
    inputs
        Input files of the same command.
    formats
        Possible extensions: a page of several plots is `.html`.

    Raises
    ------
    PitchpointError
        If the extension is another one, or the browser for SVG and PNG is missing.
    OutputError
        If the file must not be replaced, see `io.target.check_target`.
    """
    from pitchpoint.io.target import check_target

    target = Path(path)
    kind = target.suffix.lower()
    check_target(target, KINDS.get(kind, "page"), inputs)
    if kind not in formats:
        what = "has no extension of a picture" if len(formats) > 1 else "is a page of several plots"
        raise PitchpointError(f"{target.name} {what}; use {', '.join(formats)}")
    if kind != ".html":
        browser_program(kind)
    return target


def write_picture(target: Path, figure: go.Figure) -> Path:
    """Write a plot as HTML page, SVG or PNG.

    Raises
    ------
    PitchpointError
        If the browser fails or the file cannot be written.
    """
    from pitchpoint.io.target import PAGE_MARK, SVG_MARK, write_file

    kind = target.suffix.lower()
    if kind == ".html":
        body = figure.to_html(full_html=False, include_plotlyjs=True)
        head = f'<!DOCTYPE html><html><head>{PAGE_MARK}<meta charset="utf-8"></head>'
        return write_file(target, f"{head}<body>{body}</body></html>")
    made = picture_of(figure, kind)
    if kind == ".svg":
        return write_file(target, made.decode().replace(">", f">{SVG_MARK}", 1))
    return write_file(target, marked_png(made))


def marked_png(picture: bytes) -> bytes:
    """PNG with the name of the program behind its first chunk."""
    from pitchpoint.io.target import PNG_MARK

    body = b"tEXt" + PNG_MARK
    chunk = struct.pack(">I", len(PNG_MARK)) + body + struct.pack(">I", zlib.crc32(body))
    return picture[:HEADER] + chunk + picture[HEADER:]


def picture_of(figure: go.Figure, kind: str) -> bytes:
    """Contents of a picture file.

    Parameters
    ----------
    figure
        Plot with a height.
    kind
        Extension, `.svg` or `.png`.

    Raises
    ------
    PitchpointError
        If the browser is missing or fails.
    """
    height = int(figure.layout.height or 480)
    options = {
        "format": kind.removeprefix("."),
        "width": WIDTH,
        "height": height,
        "scale": 2 if kind == ".png" else 1,
    }
    page_text = f"<!DOCTYPE html><body>{figure.to_html(full_html=False, include_plotlyjs=True)}</body>"
    script = f"Plotly.toImage(document.querySelector('.js-plotly-plot'), {json.dumps(options)})"
    with open_page(browser_program(kind), WIDTH, height) as page:
        page.set_content(page_text)
        address = str(page.evaluate(script))
    head, _, body = address.partition(",")
    return base64.b64decode(body) if head.endswith("base64") else unquote_to_bytes(body)
