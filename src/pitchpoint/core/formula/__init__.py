# SPDX-License-Identifier: Apache-2.0
"""Formulas in model files: language, parser, dimensions, evaluation in compiled loops."""
