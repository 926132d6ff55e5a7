# SPDX-License-Identifier: Apache-2.0
"""Rules about files: licence line, purpose, size, names, nothing left half done."""

from __future__ import annotations

import ast
import itertools
import re
import tokenize

from tests.contracts.source import PACKAGE, ROOT, functions, is_kernel, is_public, name_of, python_files, tree

ALL = python_files()
SOURCE = python_files("src")
MAX_LINES = 400
MAX_ARGUMENTS = 10
LEFT_OVER = re.compile(r"\b(TODO|FIXME|XXX|HACK|WIP)\b|NotImplementedError|/(home|root|work|Users)/\w")
CLASS_NAMES = re.compile(r"(Manager|Helper|Util|Utils)$|^(Simulation|Config|Entity)$")


# One test looks at all files and names each that breaks its rule: thousands of tests of a millisecond would
# take the longest part of a run to be handed out and reported.


def first_statement(path):
    """Of a file, without the rest: to parse all files takes seconds."""
    with path.open("rb") as file:
        tokens = tokenize.tokenize(file.readline)
        lines = itertools.takewhile(lambda token: token.type != tokenize.NEWLINE, tokens)
        return tokenize.untokenize(lines).decode()


def test_every_file_has_licence_and_purpose():
    first = "# SPDX-License-Identifier: Apache-2.0\n"
    unmarked = [name_of(p) for p in ALL if not p.read_text(encoding="utf-8").startswith(first)]
    assert not unmarked, "first line: SPDX identifier"
    silent = [name_of(p) for p in ALL if not ast.get_docstring(ast.parse(first_statement(p)))]
    assert not silent, "a module docstring says what the file is for"


def test_files_stay_small():
    lines = {name_of(p): len(p.read_text(encoding="utf-8").splitlines()) for p in SOURCE}
    assert not {name: count for name, count in lines.items() if count > MAX_LINES}


def test_notes_are_joined_in_one_way():
    """With `join_notes`, whose separator does not occur within a note: readers divide the text again."""
    own = PACKAGE / "core" / "errors.py"
    lines = [
        f"{name_of(path)}: {line.strip()}"
        for path in SOURCE
        if path != own
        for line in path.read_text(encoding="utf-8").splitlines()
        if re.search(r'"; "\.join\(.*\b(notes?|n)\b|notes.*split\("; "\)', line)
    ]
    assert not lines, "use join_notes and split_notes"


def test_functions_take_few_arguments():
    long = []
    for path in SOURCE:
        for name, function in functions(path):
            a = function.args
            count = len(a.posonlyargs) + len(a.args) + len(a.kwonlyargs)
            count -= bool(a.args and a.args[0].arg in ("self", "cls"))
            if count > MAX_ARGUMENTS and not is_kernel(function):
                long.append(f"{name_of(path)}: {name} takes {count}")
    assert not long, f"a function with more than {MAX_ARGUMENTS} arguments is missing a noun"


def test_nothing_is_left_half_done():
    found = []
    for path in ALL:
        text = path.read_text(encoding="utf-8")
        if path.name != "test_source.py" and LEFT_OVER.search(text):
            lines = enumerate(text.splitlines(), 1)
            found += [f"{name_of(path)}:{i}: {line.strip()}" for i, line in lines if LEFT_OVER.search(line)]
    assert not found


def test_documents_name_no_machine():
    documents = list(ROOT.glob("*.md")) + sorted((ROOT / "docs").rglob("*.md"))
    found = [name_of(p) for p in documents if LEFT_OVER.search(p.read_text(encoding="utf-8"))]
    assert not found


def test_names_that_say_nothing_are_not_used():
    assert not [name_of(p) for p in ALL if p.stem in ("utils", "util", "helpers", "misc", "common")]
    classes = [
        f"{name_of(p)}: {n.name}"
        for p in SOURCE
        for n in ast.walk(tree(p))
        if isinstance(n, ast.ClassDef) and CLASS_NAMES.search(n.name)
    ]
    assert not classes


def unannotated(path):
    """Public functions of a file that lack the type of an argument or of their result."""
    bare = []
    for name, function in functions(path):
        if is_kernel(function) or not is_public(name) or path == PACKAGE / "core" / "kernel.py":
            continue
        a = function.args
        arguments = [x for x in (*a.posonlyargs, *a.args, *a.kwonlyargs, a.vararg, a.kwarg) if x is not None]
        named = [x.arg for x in arguments if x.annotation is None and x.arg not in ("self", "cls")]
        if named or function.returns is None:
            result = "..." if function.returns else "missing"
            bare.append(f"{name_of(path)}: {name}({', '.join(named)}) -> {result}")
    return bare


def test_public_functions_are_annotated():
    assert not [line for path in SOURCE for line in unannotated(path)]


def test_packages_list_and_do_not_compute():
    for path in SOURCE:
        if path.name == "__init__.py" and path.parent != PACKAGE and "stiffness" not in path.parts:
            loops = [n for n in ast.walk(tree(path)) if isinstance(n, ast.For | ast.While)]
            assert not loops, name_of(path)
