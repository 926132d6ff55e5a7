# SPDX-License-Identifier: Apache-2.0
"""Browsers of the tests of this folder, and pages that must be silent."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.support.browser import MISSING, Browsers, opening


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
    """Opens a page of a text or a file; after the test it must have said and asked for nothing."""
    with opening(browsers, tmp_path) as function:
        yield function
