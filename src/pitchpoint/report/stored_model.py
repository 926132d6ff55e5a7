# SPDX-License-Identifier: Apache-2.0
"""Model stored in a result file or in a dataset."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, ModelError, PitchpointError

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

NEAR_MODEL = "keep the result in the directory of its model file: file names are relative to it"


def stored_model(path: str, allow_code: bool = False) -> Model:
    """Load the model stored in a result file.

    Raises
    ------
    ModelError
        If the file contains no model, or it cannot be read.
    """
    from pitchpoint.io.reading import read_header

    text = read_header(path).get("model_text")
    if not text:
        remedy = "for a report, give the model file, too; else rerun the model"
        problem = Message("model", "is not stored in this result file", remedy=remedy)
        raise ModelError([problem], path)
    return model_of_text(text, path, allow_code)


def model_of(data: xr.Dataset) -> Model:
    """Load the model that a result contains as text.

    Raises
    ------
    PitchpointError
        If the result contains no model, or it cannot be read.
    """
    text = str(data.attrs.get("model_text", ""))
    if not text:
        raise PitchpointError("this result does not contain its model")
    return model_of_text(text, str(data.encoding.get("source", "result")))


def model_of_text(text: str, file: str, allow_code: bool = False) -> Model:
    """Load a model from the text in a result.

    Parameters
    ----------
    text
        The model.
    file
        The result, base of relative file names.
    allow_code
        As for `load_model`.

    Raises
    ------
    ModelError
        If the model cannot be read, such as without the files that it names.
    """
    from pitchpoint.io.yaml_model import loads_model

    try:
        return loads_model(text, allow_code=allow_code, file=file)
    except ModelError as error:
        raise ModelError([_near_model(problem) for problem in error.problems], file) from None


def _near_model(problem: Message) -> Message:
    """Problem with a file that the model names, which is not in the directory of the result."""
    from pitchpoint.model.reading.mechanism import RELATIVE

    return problem.changed(remedy=NEAR_MODEL) if (problem.remedy or "").endswith(RELATIVE) else problem
