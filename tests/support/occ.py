# SPDX-License-Identifier: Apache-2.0
"""Open CASCADE, which reads and writes STEP files: an extra that is large."""

from __future__ import annotations

import importlib.util

import pytest

needs_occ = pytest.mark.skipif(
    importlib.util.find_spec("OCP") is None, reason="OCC (the extra cad) is not installed"
)
