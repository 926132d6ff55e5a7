# SPDX-License-Identifier: Apache-2.0
"""Browsers that the tests of a file have started end with it."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.support.chromium import close_all


@pytest.fixture(scope="module", autouse=True)
def browsers() -> Iterator[None]:
    """End what has been started."""
    yield
    close_all()
