# SPDX-License-Identifier: Apache-2.0
"""The numbers in the docstrings of the geometry layer are right."""

from __future__ import annotations

import doctest
import importlib
import pkgutil

import pytest

import pitchpoint.geometry

MODULES = sorted(m.name for m in pkgutil.walk_packages(pitchpoint.geometry.__path__, "pitchpoint.geometry."))


@pytest.mark.parametrize("name", MODULES)
def test_examples_are_right(name):
    results = doctest.testmod(importlib.import_module(name))
    assert results.failed == 0
