# SPDX-License-Identifier: Apache-2.0
"""Gravity forces of all bodies."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.elements import gravity as element
from pitchpoint.system.rules.bank import Bank
from pitchpoint.system.rules.bodies import bodies

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def gravity_bank(model: Model) -> Bank:
    """One record per body with mass; empty without gravity."""
    if model.gravity is None or not any(model.gravity):
        return Bank("gravity", np.zeros(0, element.RECORD), ())
    tree = bodies(model)
    records = element.gravity_records([*tree.values()], model.gravity)
    records["i"] = np.array([*tree], dtype=np.int64)[records["i"] - 1]
    return Bank("gravity", records, tuple(tree[int(r["i"])].name for r in records))
