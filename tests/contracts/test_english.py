# SPDX-License-Identifier: Apache-2.0
"""Plain engineering English: no phrase of the glossary in messages, documents, docstrings or comments."""

from __future__ import annotations

import io
import re
import tokenize
from collections.abc import Iterator
from pathlib import Path

from tests.contracts.source import ROOT, name_of, python_files

GLOSSARY = ROOT / "docs" / "glossary.md"
EXEMPT = {GLOSSARY, ROOT / "docs" / "validation.md"}
"""The page that lists the phrases, and the results page that quotes titles of tests."""
_ROW = re.compile(r"^\|(?P<phrases>(?: ?`[^`]+` ?·?)+)\|", re.MULTILINE)
_QUOTED = re.compile(r"```.*?```|`[^`\n]*`|\]\([^)]*\)", re.DOTALL)
"""Code in Markdown, and the targets of links."""
_TEXT_OF = {
    ".js": re.compile(r"""/\*.*?\*/|//[^\n]*|"[^"\n]*"|`[^`]*`""", re.DOTALL),
    ".yaml": re.compile(r"#[^\n]*|(?:title|sentence|label): [^\n]*"),
}
"""Comments and strings of scripts; comments and sentences of model files."""


def phrases() -> list[str]:
    """The phrases of the second table of the glossary."""
    table = GLOSSARY.read_text(encoding="utf-8").split("## Phrases to replace")[1]
    return [p for row in _ROW.finditer(table) for p in re.findall(r"`([^`]+)`", row["phrases"])]


def pattern() -> re.Pattern[str]:
    """One expression for all phrases, at the ends of words, over line breaks too.

    "There is no", "is no longer", "is no wider" and "stands out" are common English.
    """
    words = [r"\s+".join(map(re.escape, w.split())) for w in sorted(phrases(), key=len, reverse=True)]
    common = r"(?!\s+(?:out|more|less|longer|wider|rarer|larger|smaller)\b)"
    return re.compile(rf"(?<![\w.-])(?<!\bthere )(?:{'|'.join(words)})(?![\w-]){common}", re.IGNORECASE)


def texts_of_python(path: Path) -> Iterator[tuple[int, str]]:
    """Strings and blocks of comments of a source file with their first lines; names are not read."""
    source = path.read_text(encoding="utf-8")
    kinds = {tokenize.STRING, tokenize.COMMENT, getattr(tokenize, "FSTRING_MIDDLE", tokenize.STRING)}
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type in kinds:
            yield token.start[0], token.string


def texts(path: Path) -> Iterator[tuple[int, str]]:
    """What people read of a file: strings and comments of code, text of pages without code."""
    if path.suffix == ".py":
        yield from texts_of_python(path)
        return
    text = path.read_text(encoding="utf-8")
    if path.suffix in _TEXT_OF:
        for found in _TEXT_OF[path.suffix].finditer(text):
            yield text.count("\n", 0, found.start()) + 1, found[0]
    else:
        yield 1, _QUOTED.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def findings(path: Path, expression: re.Pattern[str]) -> list[str]:
    """Where a file uses a phrase: name, line and phrase.

    What stands in a string or comment of Python stands in its source, too: few sources need be taken apart.
    """
    if path.suffix == ".py" and not expression.search(path.read_text(encoding="utf-8")):
        return []
    return [
        f"{name_of(path)}:{line + text[: hit.start()].count(chr(10))}: {' '.join(hit[0].split())}"
        for line, text in texts(path)
        for hit in expression.finditer(text)
    ]


def files() -> list[Path]:
    """Everything of the project that people read, but for the tests."""
    pages = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "examples").rglob("*.md")]
    scripts = (ROOT / "viewer" / "src").glob("*.js")
    models = [*(ROOT / "examples").rglob("*.yaml"), ROOT / "docs" / "gallery.yaml"]
    table = ROOT / "src" / "pitchpoint" / "core" / "nomenclature.csv"
    found = [*python_files("src", "examples", "benchmarks", "docs"), *pages, *scripts, *models, table]
    return sorted(set(found) - EXEMPT)


def test_phrases_are_found_across_lines():
    """The expression finds what it should, and leaves longer words alone."""
    expression = pattern()
    assert expression.search("springs one behind the\n    other")
    assert expression.search("motor is\n no body")
    assert not expression.search("standard understanding apartment a-stand")


def test_findings_have_place_and_phrase(tmp_path, monkeypatch):
    """In a comment and in a string, not in names."""
    monkeypatch.setattr("tests.contracts.test_english.name_of", lambda path: path.name)
    phrase = phrases()[0]
    file = tmp_path / "some.py"
    file.write_text(f"{{}}\n# {phrase}\nx = f'{phrase} {{{{}}}}'\n", encoding="utf-8")
    assert findings(file, pattern()) == [f"some.py:{line}: {phrase}" for line in (2, 3)]


def test_no_phrase_of_the_glossary_is_used():
    expression = pattern()
    assert not [line for path in files() for line in findings(path, expression)]
