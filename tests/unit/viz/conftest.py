# SPDX-License-Identifier: Apache-2.0
"""Small, physically sensible data for pictures: a pair, a steady run, a run-up, a sweep with jumps."""

from __future__ import annotations

import pytest

from pitchpoint.viz.report.build import ReportModel, ReportResults
from tests.support.report_data import report_model, report_results


@pytest.fixture(scope="session")
def model() -> ReportModel:
    return report_model()


@pytest.fixture(scope="session")
def results() -> ReportResults:
    return report_results()
