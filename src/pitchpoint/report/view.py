# SPDX-License-Identifier: Apache-2.0
"""`write_view`: the 3-D scene of a model or a result, or of two side by side, as one HTML page."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

from pitchpoint.core.errors import PitchpointError, ValidityWarning

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model
    from pitchpoint.viz.scene import Scene

RESULT_ENDINGS = (".h5", ".nc", ".hdf5")


def write_view(
    path_out: str | os.PathLike[str],
    *sources: Model | str | os.PathLike[str] | xr.Dataset,
    allow_code: bool = False,
    modes: int = 0,
) -> tuple[Path, tuple[str, ...]]:
    """Write one self-contained HTML page with the scene of a model or a result.

    Parameters
    ----------
    path_out
        The HTML file to write.
    *sources
        A model or its file, or a result over time or of modes, or its file; two of them are shown side by
        side.
    allow_code
        Let model files run the Python functions that they name.
    modes
        How many of the lowest modes are computed and shown, if there is one source.

    Returns
    -------
    Path
        The file written.
    tuple
        What is not shown, in sentences.

    Raises
    ------
    ModelError
        If a model file is wrong, or a result keeps no model.
    PitchpointError
        If a result holds no motion, or the page cannot be written or would destroy another file.
    """
    from pitchpoint.io.target import check_target, write_file
    from pitchpoint.report.write import files_of
    from pitchpoint.viz.scene_page import scene_page

    path = check_target(path_out, "page", files_of(*sources))
    scenes = [_scene(source, allow_code, modes) for source in sources]
    written = write_file(path, scene_page(*scenes))
    return written, tuple(dict.fromkeys(note for s in scenes for note in s.notes))


def _scene(source: Model | str | os.PathLike[str] | xr.Dataset, allow_code: bool, modes: int) -> Scene:
    from pitchpoint.io.reading import open_result
    from pitchpoint.io.yaml_model import load_model, loads_model
    from pitchpoint.model.model import Model
    from pitchpoint.report.kept_model import kept_model
    from pitchpoint.report.scene import scene_of

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ValidityWarning)  # it was said when the result was made
        if isinstance(source, Model):
            return scene_of(source, modes=modes)
        if isinstance(source, str | os.PathLike):
            name = os.fspath(source)
            if not name.lower().endswith(RESULT_ENDINGS):
                return scene_of(load_model(name, allow_code=allow_code), modes=modes)
            model, result = kept_model(name, allow_code), open_result(name)
        else:
            result = source
            name = str(result.encoding.get("source", "result"))
            model = loads_model(str(result.attrs.get("model_text", "")), allow_code=allow_code, file=name)
        if "time" not in result.dims and "body_shape" not in result:
            kind = result.attrs.get("kind", "no time run")
            raise PitchpointError(
                f"{name}: holds nothing that moves over time ({kind}); view a time run or modes"
            )
        return scene_of(model, result, modes=modes)
