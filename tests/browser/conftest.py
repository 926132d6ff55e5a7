# SPDX-License-Identifier: Apache-2.0
"""Browsers of the tests of this folder, and pages that must be silent."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.support.browser import MISSING, Browsers, OpenPage, opening
from tests.support.scene_browser import as_at_first, scene


@pytest.fixture(scope="package")
def browsers() -> Iterator[Browsers]:
    """Those of this process; they end when it leaves this folder."""
    if MISSING:
        pytest.skip(MISSING)
    found = Browsers()
    yield found
    found.close()


@pytest.fixture
def open_page(browsers: Browsers, tmp_path: Path) -> Iterator[Callable[..., Any]]:
    """Opens a page of a text or a file; after the test it must have said and requested nothing."""
    with opening(browsers, tmp_path) as function:
        yield function


@pytest.fixture(scope="module")
def scenes_of_file(browsers: Browsers, tmp_path_factory: pytest.TempPathFactory) -> Iterator[OpenPage]:
    """Opens a scene once for all tests of a file."""
    found: dict[Any, Any] = {}
    with opening(browsers, tmp_path_factory.mktemp("scenes")) as open_page:

        def same(text: tuple[str, str]) -> Any:
            if text not in found:
                found[text] = scene(open_page, text)
            return found[text]

        yield same


@pytest.fixture
def same_scene(browsers: Browsers, scenes_of_file: OpenPage) -> Iterator[OpenPage]:
    """A scene that other tests of the file look at too, as it was at first: mounting one takes a second."""
    used = []

    def same(text: tuple[str, str]) -> Any:
        used.append(scenes_of_file(text))
        as_at_first(used[-1])
        return used[-1]

    yield same
    for page in used:
        browsers.judge(page)
