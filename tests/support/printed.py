# SPDX-License-Identifier: Apache-2.0
"""Comparison with printed numbers: the tolerance is half a unit of the last printed digit."""

from __future__ import annotations

import pytest


def printed(text: str, units: float = 0.5):
    """What a source prints, equal to anything that rounds to it.

    `units` widens the tolerance to that many units of the last digit; a test that does so says why.
    """
    digits = len(text.split(".")[1]) if "." in text else 0
    return pytest.approx(float(text), rel=0.0, abs=(units + 1e-6) * 10.0**-digits)
