# SPDX-License-Identifier: Apache-2.0
"""Drawings for notebooks and files."""

from __future__ import annotations


class Picture:
    """HTML or SVG for display in Jupyter or as a file."""

    def __init__(self, html: str) -> None:
        self.html = html

    def __repr__(self) -> str:
        kind = "SVG" if self.html.startswith("<svg") else "HTML"
        return f"<Picture: {kind}, {1e-3 * len(self.html):.0f} kB; a notebook shows it, save(path) writes it>"

    def _repr_html_(self) -> str:
        return self.html

    def save(self, path: str) -> None:
        """Write the picture to a file for a browser."""
        from pathlib import Path

        # a single SVG is a complete file; other content requires an HTML page
        bare = self.html.startswith("<svg")
        text = self.html if bare else f'<!DOCTYPE html><meta charset="utf-8">{self.html}'
        Path(path).write_text(text, encoding="utf-8")
