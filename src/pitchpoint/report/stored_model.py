# SPDX-License-Identifier: Apache-2.0
"""Model stored in a result file or in a dataset."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, ModelError, PitchpointError

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model


def stored_model(path: str, allow_code: bool = False) -> Model:
    """Load the model stored in a result file.

    Raises
    ------
    ModelError
        If the file contains no model, or it cannot be read.
    """
    from pitchpoint.io.reading import read_header
    from pitchpoint.io.yaml_model import loads_model

    text = read_header(path).get("model_text")
    if not text:
        remedy = "for a report, give the model file, too; else rerun the model"
        problem = Message("model", "is not stored in this result file", remedy=remedy)
        raise ModelError([problem], path)
    return loads_model(text, allow_code=allow_code, file=path)


def model_of(data: xr.Dataset) -> Model:
    """Load the model that a result contains as text.

    Raises
    ------
    PitchpointError
        If the result contains no model, or it cannot be read.
    """
    from pitchpoint.io.yaml_model import loads_model

    text = str(data.attrs.get("model_text", ""))
    if not text:
        raise PitchpointError("this result does not contain its model")
    return loads_model(text, file=str(data.encoding.get("source", "result")))
