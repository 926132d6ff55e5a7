# SPDX-License-Identifier: Apache-2.0
"""Formulas in model files: language, parser, dimension check, evaluation in kernels."""
