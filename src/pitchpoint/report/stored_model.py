# SPDX-License-Identifier: Apache-2.0
"""The model that a result file keeps."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, ModelError

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def stored_model(path: str, allow_code: bool = False) -> Model:
    """Load the text of the model that a result file keeps.

    Raises
    ------
    ModelError
        If the file keeps none, or it cannot be read.
    """
    from pitchpoint.io.reading import read_header
    from pitchpoint.io.yaml_model import loads_model

    text = read_header(path).get("model_text")
    if not text:
        remedy = "for a report, name the model file as well; else run the model again"
        problem = Message("model", "is not kept in this result file", remedy=remedy)
        raise ModelError([problem], path)
    return loads_model(text, allow_code=allow_code, file=path)
