# SPDX-License-Identifier: Apache-2.0
"""Equations as MathML at build time: browsers draw it themselves, so that no page needs a script or a network.

The font with the shapes of mathematics, STIX Two Math (SIL Open Font License), comes with the package ziamath and
is copied beside the pages.
"""

from __future__ import annotations

import importlib.util
import re
import shutil
from pathlib import Path
from typing import Any

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError

FONT = "STIXTwoMath-Regular.ttf"


def to_mathml(latex: str, display: str) -> str:
    """MathML of one formula.

    Parameters
    ----------
    latex
        The formula, without dollar signs.
    display
        `inline` or `block`.

    Returns
    -------
    str
        A `math` element.
    """
    # a command that the converter does not know would come out as its own name in red ink of the reader
    found = convert(latex, display=display)
    left = re.search(r"<m[a-z]+>\\[A-Za-z]+</m", found)
    if left:
        raise ExtensionError(f"formula {latex!r}: {left[0]!r} is no command that can be converted")
    return found


def visit_inline(self: Any, node: nodes.math) -> None:
    """Write a formula within a line."""
    self.body.append(to_mathml(node.astext(), "inline"))
    raise nodes.SkipNode


def visit_block(self: Any, node: nodes.math_block) -> None:
    """Write a formula on lines of its own, with its number if it has a label."""
    self.body.append(self.starttag(node, "div", CLASS="equation"))
    self.body.append(to_mathml(node.astext(), "block"))
    if node.get("number"):
        self.body.append(f'<span class="eqno">({node["number"]})</span>')
    self.body.append("</div>\n")
    raise nodes.SkipNode


def copy_font(app: Sphinx, exception: Exception | None) -> None:
    """Put the font beside the style sheet."""
    package = importlib.util.find_spec("ziamath")
    if exception or package is None or package.origin is None:
        return
    target = Path(app.outdir) / "_static"
    target.mkdir(exist_ok=True)
    shutil.copyfile(Path(package.origin).parent / "fonts" / FONT, target / FONT)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx."""
    app.add_html_math_renderer("mathml", (visit_inline, None), (visit_block, None))
    app.connect("build-finished", copy_font)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
