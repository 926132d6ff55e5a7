# SPDX-License-Identifier: Apache-2.0
"""Limits of the measured errors of contact tables: above them a table is not accurate enough."""

from __future__ import annotations

from collections.abc import Mapping

from pitchpoint.core.errors import Message, note

LIMITS = {
    "force": (0.01, "force", "the nominal force F_bt"),
    "tilting_moment": (0.05, "tilting moment", "F_bt b/2"),
}
"""Maximum rms error over the nominal value, name and nominal value of the derivatives by x and kappa.

Usual tables have 0.015 to 0.1 % for the force, and below 1 % for the tilting moment; the limits are ten and
five times the upper ends. The excitation, the change of the force over the mesh cycle, begins at some percent
of the force: with an error of 1 % it is no longer that of the gears. The tilting moment of misaligned flanks
is some tens of percent of F_bt b/2, and 5 % of that displaces the force by 2.5 % of the face width.
"""


def inaccuracy(errors: Mapping[str, Mapping[str, tuple[float, float, float]]]) -> Message | None:
    """Note on the measured error that exceeds its limit most; None if all are within their limits.

    Parameters
    ----------
    errors
        Errors of a `PotentialTable` (rms, maximum and rms of the quantity, in nominal values) by flank,
        "front" and "back".

    Notes
    -----
    Derivation: docs/theory/stiffness.md, "Pre-computed flank contact".

    Examples
    --------
    >>> inaccuracy({"front": {"force": (0.03, 0.2, 0.5)}, "back": {"force": (0.02, 0.1, 0.5)}}).text
    'rms error of the force on the front flanks is 3 % of the nominal force F_bt'
    >>> inaccuracy({"front": {"force": (0.001, 0.02, 0.5)}}) is None
    True
    """
    sizes = [
        (measured[name][0], limit, f"{words} on the {flank} flanks", nominal)
        for flank, measured in errors.items()
        for name, (limit, words, nominal) in LIMITS.items()
        if name in measured
    ]
    error, limit, words, nominal = max(sizes, key=lambda e: e[0] / e[1], default=(0.0, 1.0, "", ""))
    if error <= limit:
        return None
    found = note(
        f"rms error of the {words} is {100.0 * error:.2g} % of {nominal}",
        remedy="compute a table with a narrower range of misalignment, centre distance or torque, or a finer "
        "one, in Python with a larger TableSize",
    )
    return found.changed(limit=f"{100.0 * limit:g} %")
