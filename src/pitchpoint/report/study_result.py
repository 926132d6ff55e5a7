# SPDX-License-Identifier: Apache-2.0
"""Statistics of a study from its dataset, for plots."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.study.summary import FactorSample, ResultSample, StudySummary, summary_of
from pitchpoint.core.status import OK

if TYPE_CHECKING:
    import xarray as xr


def study_summary(data: xr.Dataset) -> StudySummary:
    """Summary of a study.

    Parameters
    ----------
    data
        Dataset of `run_study`, or of its file.
    """
    options = json.loads(str(data.attrs["options"]))
    factors = []
    for name, nominal in zip(data["factor"].values, data["factor_nominal"].values, strict=True):
        one = data[f"factor[{name}]"]
        labels: tuple[str, ...] = ()
        numbers = one.values
        if numbers.dtype.kind not in "fiu":
            known, numbers = np.unique(numbers.astype(str), return_inverse=True)
            labels = tuple(map(str, known))
        words, unit = str(one.attrs.get("long_name", "")), str(one.attrs.get("units", ""))
        values = np.asarray(numbers, np.float64)
        factors.append(FactorSample(str(name), words, unit, values, labels, float(nominal)))
    results = [
        ResultSample(
            str(name),
            str(data[f"result[{name}]"].attrs.get("long_name", "")),
            str(data[f"result[{name}]"].attrs.get("units", "")),
            np.asarray(data[f"result[{name}]"].values, np.float64),
            *(float(data[key].sel(result=name)) for key in ("nominal", "lower_limit", "upper_limit")),
        )
        for name in data["result"].values
    ]
    return summary_of(
        factors,
        results,
        np.asarray(data["group"].values, np.intp),
        np.asarray(data["status"].values) == OK,
        confidence=float(options["confidence"]),
        indices="total_index" in data,
    )
