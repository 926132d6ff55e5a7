# SPDX-License-Identifier: Apache-2.0
"""The documentation site without building it: pages are reachable, links lead somewhere, theory is whole."""

from __future__ import annotations

import ast
import re
from pathlib import Path

from ruamel.yaml import YAML

import pitchpoint
from tests.contracts.source import PACKAGE

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
# written by docs/generate.py when the site is built
MADE = {
    "changelog.md",
    "contributing.md",
    "gallery/index.md",
    "howto/pair.yaml",
    *(f"reference/{name}.md" for name in ("commands", "model-file", "nomenclature", "units")),
    *(f"reference/api/{name}.md" for name in ("pitchpoint", "geometry", "contact", "analysis")),
}
PAGES = sorted(DOCS.rglob("*.md"))
LINK = re.compile(r"(?<!!)\[[^\]\n]*\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ +(.*)$", re.MULTILINE)
# layers whose equations the theory has, and what shows that a file has some: a source
LAYERS = ("geometry", "contact", "multibody", "elements", "solvers", "analysis")
SOURCED = re.compile(r"\b(ISO|DIN|VDI) ?\d|\b(1[89]|20)\d\d\b")


def name_of(page: Path) -> str:
    """Path of a page from the folder of the documentation."""
    return page.relative_to(DOCS).as_posix()


def without_code(text: str) -> str:
    """Text of a page without its blocks of code."""
    return re.sub(r"^(```+)(?!\{toctree\})[^\n]*\n.*?^\1", "", text, flags=re.DOTALL | re.MULTILINE)


def places(page: Path) -> set[str]:
    """Names of the headings of a page, as links call them."""
    plain = (re.sub(r"[`*]", "", heading).lower() for heading in HEADING.findall(page.read_text("utf-8")))
    return {re.sub(r"[^\w\- ]", "", heading).strip().replace(" ", "-") for heading in plain}


def toctree_entries(page: Path) -> set[str]:
    """Pages that the toctrees of a page name, from the folder of the documentation."""
    found = set()
    for block in re.findall(r"^```\{toctree\}\n(.*?)^```", page.read_text("utf-8"), re.DOTALL | re.MULTILINE):
        for line in block.splitlines():
            entry = re.sub(r".*<(.*)>$", r"\1", line.strip())
            if not entry or entry.startswith(":"):
                continue
            target = (page.parent / f"{entry}.md").resolve()
            matches = page.parent.glob(f"{entry}.md") if "*" in entry else [target]
            found |= {match.resolve().relative_to(DOCS).as_posix() for match in matches}
    return found


def test_every_page_is_in_a_toctree_and_every_entry_is_a_page() -> None:
    named = set().union(*(toctree_entries(page) for page in PAGES)) | {"index.md"}
    assert {name_of(page) for page in PAGES} - named == set()
    assert named - {name_of(page) for page in PAGES} - MADE == set()


def test_links_between_pages_resolve() -> None:
    assert not [f"{name_of(page)}: {link}" for page in PAGES for link in lost_links(page)]


def lost_links(page: Path) -> list[str]:
    """Links of a page that lead nowhere."""
    lost = []
    for link in LINK.findall(without_code(page.read_text("utf-8"))):
        path, _, place = link.partition("#")
        if re.match(r"[a-z]+:", link):
            continue
        target = (page.parent / path).resolve() if path else page
        inside = target.is_relative_to(DOCS)
        name = target.relative_to(DOCS).as_posix() if inside else ""
        example = re.fullmatch(r"gallery/([\w-]+)/index\.md", name)
        if name in MADE or (example and (ROOT / "examples" / example[1] / "README.md").exists()):
            continue
        if not inside or not target.exists() or (place and place not in places(target)):
            lost.append(link)
    return lost


def test_cards_link_to_pages() -> None:
    """The target and the type of the link are options on lines of their own."""
    for page in PAGES:
        text = page.read_text("utf-8")
        targets = re.findall(r"^:link: (.*)$", text, re.MULTILINE)
        types = re.findall(r"^:link-type: doc$", text, re.MULTILINE)
        assert len(targets) == text.count("grid-item-card}") == len(types), page
        assert not [t for t in targets if not (page.parent / f"{t}.md").exists()], page


def test_every_example_has_a_card_and_a_small_picture() -> None:
    cards = YAML(typ="safe").load((DOCS / "gallery.yaml").read_text("utf-8"))
    assert set(cards) == {path.parent.name for path in (ROOT / "examples").glob("*/README.md")}
    for name, card in cards.items():
        assert card["sentence"].endswith(".")
        path = DOCS / "images" / "gallery" / f"{name}.webp"
        assert path.exists()
        assert path.stat().st_size <= 60_000


def test_theory_names_every_file_that_has_sources_and_no_other() -> None:
    text = "".join(p.read_text("utf-8") for p in [*(DOCS / "theory").glob("*.md"), DOCS / "physics.md"])
    named = set(re.findall(rf"`((?:{'|'.join(LAYERS)})/[\w/]+\.py)`", text))
    assert {name for name in named if not (PACKAGE / name).exists()} == set()
    missing = [
        path.relative_to(PACKAGE).as_posix()
        for layer in LAYERS
        for path in sorted((PACKAGE / layer).rglob("[!_]*.py"))
        if path.relative_to(PACKAGE).as_posix() not in named and SOURCED.search(docstrings(path))
    ]
    assert missing == [], "say on a page of docs/theory what they compute"


def docstrings(path: Path) -> str:
    """All docstrings of a file."""
    kinds = ast.Module | ast.FunctionDef | ast.ClassDef
    tree = ast.parse(path.read_text("utf-8"))
    return "\n".join(ast.get_docstring(node) or "" for node in ast.walk(tree) if isinstance(node, kinds))


def test_every_public_name_is_in_a_group_of_the_reference() -> None:
    tree = ast.parse((DOCS / "make_api.py").read_text(encoding="utf-8"))
    groups = next(
        ast.literal_eval(node.value)
        for node in tree.body
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "GROUPS"
    )
    assert {name for names in groups.values() for name in names} == set(pitchpoint.__all__) - {"__version__"}
