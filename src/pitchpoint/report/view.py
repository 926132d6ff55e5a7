# SPDX-License-Identifier: Apache-2.0
"""`write_view`: 3-D scene of a model or a result, or of two next to each other, as one HTML page."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from pitchpoint.core.errors import PitchpointError, ValidityWarning

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model
    from pitchpoint.viz.scene.content import Scene
    from pitchpoint.viz.scene.page import SceneStart

RESULT_ENDINGS = (".h5", ".nc", ".hdf5")


def write_view(
    path_out: str | os.PathLike[str],
    *sources: Model | str | os.PathLike[str] | xr.Dataset,
    allow_code: bool = False,
    modes: int = 0,
    start: SceneStart | None = None,
) -> tuple[Path, tuple[str, ...]]:
    """Write one self-contained HTML page with the scene of a model or a result.

    Parameters
    ----------
    path_out
        The HTML file to write.
    *sources
        Model or its file, or result of a time run or of modes, or its file; two sources are shown next to
        each other.
    allow_code
        Allow model files to run the Python functions that they name.
    modes
        Number of lowest modes that are computed and shown, for a single source.
    start
        Initial view: direction, projection, section.

    Returns
    -------
    Path
        Written file.
    tuple
        Remarks on omitted content.

    Raises
    ------
    ModelError
        If a model file is invalid, or a result contains no model.
    PitchpointError
        If a result contains no motion, or the page cannot be written or would overwrite an input file.
    """
    from pitchpoint.io.target import check_target, write_file
    from pitchpoint.report.write import files_of
    from pitchpoint.viz.scene.page import scene_page

    path = check_target(path_out, "page", files_of(*sources))
    scenes = [_scene(source, allow_code, modes) for source in sources]
    if len(scenes) > 1:
        names = file_labels([_name(source) for source in sources])
        scenes = [replace(scene, label=name) for scene, name in zip(scenes, names, strict=True)]
    written = write_file(path, scene_page(*scenes, start=start))
    return written, tuple(dict.fromkeys(note for s in scenes for note in s.notes))


def file_labels(files: Sequence[str]) -> list[str]:
    """Names of files without their common folders; empty for sources without a file.

    Parameters
    ----------
    files
        Paths, empty for sources without a file.

    Examples
    --------
    >>> file_labels(["out/healthy.h5", "out/broken.h5"])
    ['healthy.h5', 'broken.h5']
    >>> file_labels(["monday/night/run.h5", "tuesday/night/run.h5"])
    ['monday/night/run.h5', 'tuesday/night/run.h5']
    """
    parts = [Path(file).absolute().parts if file else () for file in files]
    for count in range(1, max(map(len, parts)) + 1):
        found = ["/".join(each[-count:]) for each in parts]
        if len(set(found)) == len(found):
            return found
    return [Path(file).name if file else "" for file in files]


def _name(source: Model | str | os.PathLike[str] | xr.Dataset) -> str:
    """File of a source, empty if none."""
    from pitchpoint.model.model import Model

    if isinstance(source, Model):
        return source.file or ""
    if isinstance(source, str | os.PathLike):
        return os.fspath(source)
    return str(source.encoding.get("source", ""))


def _scene(source: Model | str | os.PathLike[str] | xr.Dataset, allow_code: bool, modes: int) -> Scene:
    from pitchpoint.io.opening import understood
    from pitchpoint.io.reading import open_result
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.model.model import Model
    from pitchpoint.report.scene.build import scene_of
    from pitchpoint.report.stored_model import model_of_text, stored_model

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ValidityWarning)  # reported when the result was computed
        if isinstance(source, Model):
            return scene_of(source, modes=modes)
        if isinstance(source, str | os.PathLike):
            name = os.fspath(source)
            if not name.lower().endswith(RESULT_ENDINGS):
                return scene_of(load_model(name, allow_code=allow_code), modes=modes)
            model = stored_model(name, allow_code)
            with open_result(name) as result, understood(name):
                return _motion(model, result, name, modes)
        else:
            result = source
            name = str(result.encoding.get("source", "result"))
            model = model_of_text(str(result.attrs.get("model_text", "")), name, allow_code)
        return _motion(model, result, name, modes)


def _motion(model: Model, result: xr.Dataset, name: str, modes: int) -> Scene:
    """Scene of a model with the motion of a result."""
    from pitchpoint.report.scene.build import scene_of

    if "time" not in result.dims and "body_shape" not in result:
        kind = result.attrs.get("kind", "no time run")
        raise PitchpointError(f"{name}: contains no motion over time ({kind}); view a time run or modes")
    return scene_of(model, result, modes=modes)
