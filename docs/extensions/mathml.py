# SPDX-License-Identifier: Apache-2.0
"""Equations as MathML at build time: browsers draw it, so that no page needs a script or a network.

The font with the shapes of mathematics, STIX Two Math (SIL Open Font License), comes with the package ziamath
and is copied next to the pages.
"""

from __future__ import annotations

import importlib.util
import re
import shutil
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError

FONT = "STIXTwoMath-Regular.ttf"
NAMESPACE = "{http://www.w3.org/1998/Math/MathML}"
WORD = re.compile(r"[A-Za-z]{2,}")


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
    found = convert(latex.replace("{aligned}", "{align*}"), display=display)
    # a command that the converter does not know would come out as its own name
    left = re.search(r">(\\[A-Za-z]+|&amp;)<", found)
    if left:
        raise ExtensionError(f"formula {latex!r}: {left[1]!r} cannot be converted")
    ElementTree.register_namespace("", NAMESPACE[1:-1])
    tree = ElementTree.fromstring(found)
    for row in tree.iter():
        space_functions(row)
        # browsers follow MathML Core, which leaves alignment to style sheets
        if row.tag == f"{NAMESPACE}mtd" and "columnalign" in row.attrib:
            row.set("style", f"text-align: {row.attrib.pop('columnalign')}")
    return ElementTree.tostring(tree, encoding="unicode")


def space_functions(row: ElementTree.Element) -> None:
    """Set names of functions off from their neighbours: thin spaces, as in a book."""
    for child in row:
        # an operator would have spaces on both sides that are too wide
        if child.tag == f"{NAMESPACE}mo" and WORD.fullmatch(child.text or ""):
            child.tag = f"{NAMESPACE}mi"
    if row.tag not in (f"{NAMESPACE}mrow", f"{NAMESPACE}mtd", f"{NAMESPACE}math", f"{NAMESPACE}mstyle"):
        return
    children = list(row)
    for number, child in reversed(list(enumerate(children))):
        if not is_function(child):
            continue
        after = children[number + 1] if number + 1 < len(children) else None
        if after is not None and (after.tag != f"{NAMESPACE}mo") and not opens(after):
            row.insert(number + 1, thin_space())
        if number and children[number - 1].tag != f"{NAMESPACE}mo" and not is_function(children[number - 1]):
            row.insert(number, thin_space())


def is_function(element: ElementTree.Element) -> bool:
    """Whether an element is the name of a function, with or without an exponent."""
    base = element[0] if element.tag in (f"{NAMESPACE}msup", f"{NAMESPACE}msub") and len(element) else element
    return base.tag == f"{NAMESPACE}mi" and WORD.fullmatch(base.text or "") is not None


def opens(element: ElementTree.Element) -> bool:
    """Whether an element begins with a bracket, which needs no space before it."""
    while len(element):
        element = element[0]
    return element.get("form") == "prefix" and element.get("fence") == "true"


def thin_space() -> ElementTree.Element:
    """Sixth of an em."""
    return ElementTree.Element(f"{NAMESPACE}mspace", {"width": "0.167em"})


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
    """Put the font next to the style sheet."""
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
