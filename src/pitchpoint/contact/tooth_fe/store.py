# SPDX-License-Identifier: Apache-2.0
"""Results of finite elements on disk, by their input and by the source that computed them."""

from __future__ import annotations

import contextlib
import hashlib
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from pitchpoint.contact.tooth_fe import solve
from pitchpoint.contact.tooth_fe.tooth import ToothFE
from pitchpoint.contact.tooth_fe.tooth_model import ToothModel
from pitchpoint.core.compiler.machine_code import source_stamp
from pitchpoint.core.provenance import content_hash
from pitchpoint.core.user_cache import user_cache


def file_of(model: ToothModel) -> Path:
    """Path of the stored result of a model, whether it exists or not.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> file_of(ToothModel(gear=CylindricalGear(z=17, m_n=1e-3))).parent.name
    'tooth_fe'
    """
    key = f"{content_hash(model)} {source_stamp(str(solve.__file__))}"
    return user_cache() / "tooth_fe" / f"{hashlib.sha256(key.encode()).hexdigest()[:32]}.npz"


def stored_tooth_fe(model: ToothModel) -> ToothFE:
    """Result of a model from the disk, or computed and stored.

    Parameters
    ----------
    model
        The gear.

    Raises
    ------
    GeometryError
        If tooth or body are not possible.

    Notes
    -----
    A damaged file is replaced. A folder that is not writable only costs time.

    Examples
    --------
    >>> from pitchpoint.contact.tooth_fe.tooth_model import Resolution
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> small = Resolution(heights=1, widths=1, fillet_points=1)
    >>> stored_tooth_fe(ToothModel(gear=CylindricalGear(z=17, m_n=1e-3), resolution=small)).same.shape
    (1, 1, 1, 1)
    """
    file = file_of(model)
    with contextlib.suppress(Exception), np.load(file, allow_pickle=False) as arrays:  # any damage
        return ToothFE.from_arrays(arrays)
    found = solve.tooth_fe(model)
    data: Any = found.to_arrays()
    with contextlib.suppress(OSError):
        file.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=file.parent) as draft:
            whole = Path(draft, file.name)
            np.savez(whole, **data)
            whole.replace(file)  # atomic, for concurrent readers
    return found
