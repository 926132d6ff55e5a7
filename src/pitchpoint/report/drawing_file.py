# SPDX-License-Identifier: Apache-2.0
"""SVG drawings as files: SVG and HTML pages directly, PNG and PDF with the browser of the system."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from pathlib import Path

from pitchpoint.core.errors import PitchpointError
from pitchpoint.report.browser import browser_program, open_page
from pitchpoint.report.figure_picture import KINDS, marked_png

FORMATS = {**KINDS, ".pdf": "pdf"}
"""Kinds of files of drawings by their extensions, see `io.target`."""
SCALE = 2
"""Pixels of a PNG per pixel of the drawing."""


def check_drawing(path: str | os.PathLike[str], inputs: Iterable[str | os.PathLike[str]] = ()) -> Path:
    """Path of a drawing; checks before a computation that it can be written.

    Parameters
    ----------
    path
        File to write: svg, html, png or pdf.
    inputs
        Input files of the same command.

    Raises
    ------
    PitchpointError
        If the extension is another one, or the browser for PNG and PDF is missing.
    OutputError
        If the file must not be replaced, see `io.target.check_target`.
    """
    from pitchpoint.io.target import check_target

    target = Path(path)
    kind = target.suffix.lower()
    if kind not in FORMATS:
        raise PitchpointError(f"{target.name} has no extension of a drawing; use .svg, .html, .png or .pdf")
    check_target(target, FORMATS[kind], inputs)
    if kind in (".png", ".pdf"):
        browser_program(kind)
    return target


def write_drawing(target: Path, drawing: str) -> Path:
    """Write an SVG drawing in the format of the extension.

    Parameters
    ----------
    target
        File from `check_drawing`.
    drawing
        The drawing, from `viz.svg.document`.

    Raises
    ------
    PitchpointError
        If the browser fails or the file cannot be written.
    """
    from pitchpoint.io.target import PAGE_MARK, SVG_MARK, write_file

    kind = target.suffix.lower()
    if kind == ".svg":
        return write_file(target, drawing.replace(">", f">{SVG_MARK}", 1))
    if kind == ".html":
        head = f'<!DOCTYPE html><html><head>{PAGE_MARK}<meta charset="utf-8"></head>'
        return write_file(target, f"{head}<body>{drawing}</body></html>")
    made = _browsed(drawing, kind)
    return write_file(target, marked_png(made) if kind == ".png" else made)


def _browsed(drawing: str, kind: str) -> bytes:
    """Picture, or vector drawing on one page, in the size of the drawing."""
    from pitchpoint.io.target import PDF_TITLE

    size = re.search(r'viewBox="0 0 (\d+) (\d+)"', drawing)
    width, height = (int(x) for x in size.groups()) if size else (1000, 1000)
    with open_page(browser_program(kind), width, height, SCALE) as page:
        page.set_content(
            f"<!DOCTYPE html><title>{PDF_TITLE}</title>"
            f"<style>@page{{margin:0;size:{width}px {height}px}}</style>"
            f'<body style="margin:0">{drawing}</body>'
        )
        if kind == ".png":
            return page.screenshot(clip={"x": 0, "y": 0, "width": width, "height": height})
        page.emulate_media(media="screen", color_scheme="light")
        return page.pdf(prefer_css_page_size=True, print_background=True, page_ranges="1")
