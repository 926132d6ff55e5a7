# SPDX-License-Identifier: Apache-2.0
"""Full-field files of TurbSim (.bts), written; `model/wind/turbsim.py` reads them and has the layout."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from pitchpoint.io.target import (
    TURBSIM_MARK,
    OutputError,
    cannot_be_written,
    check_target,
    make_folder,
    replacing,
)
from pitchpoint.model.wind.box import WindBox
from pitchpoint.model.wind.file_errors import refused
from pitchpoint.model.wind.turbsim import BLOCK, HEADER, ONCE, PERIODIC


def write_turbsim(path: str | os.PathLike[str], box: WindBox) -> Path:
    """Write a full-field file of TurbSim.

    The rounding error of a component is half of its range over 65 535.

    Parameters
    ----------
    path
        The file (.bts).
    box
        Velocities with the mean wind, see `add_mean`.

    Raises
    ------
    WindFileError
        If the box contains fluctuations only.
    OutputError
        If the file cannot be written.
    """
    target = check_target(path, "turbsim")
    if not box.with_mean:
        remedy = "add the mean wind with add_mean"
        raise refused(target, "", "", "would contain fluctuations without the mean wind", None, remedy)
    velocity = box.velocity
    low, high = (
        limit.astype(float) for limit in (velocity.min(axis=(0, 1, 2)), velocity.max(axis=(0, 1, 2)))
    )
    span = high - low
    slope = np.where(span > 0.0, 65535.0 / np.where(span > 0.0, span, 1.0), 1.0).astype(np.float32)
    offset = (-32768.0 - slope.astype(float) * low).astype(np.float32)
    head = np.zeros((), HEADER)
    head["id"] = PERIODIC if box.periodic else ONCE
    head["n_t"], head["n_z"], head["n_y"], _ = velocity.shape
    head["dt"], (head["dy"], head["dz"]) = box.time_step, box.spacing
    head["mean_speed"], head["hub_height"], head["bottom"] = box.mean_speed, box.hub_height, box.bottom
    head["scale"] = np.stack([slope, offset], axis=1)
    head["n_text"] = len(TURBSIM_MARK)
    try:
        make_folder(target)
        with replacing(target) as draft, draft.open("wb") as file:
            file.write(head.tobytes() + TURBSIM_MARK)
            step = max(1, BLOCK // velocity[0].size)
            for k in range(0, len(velocity), step):
                scaled = np.rint(velocity[k : k + step] * slope.astype(float) + offset.astype(float))
                file.write(np.clip(scaled, -32768, 32767).astype("<i2").tobytes())
            file.flush()
            os.fsync(file.fileno())
    except (OSError, ValueError) as error:
        raise OutputError(cannot_be_written(target, error)) from error
    return target
