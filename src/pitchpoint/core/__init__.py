# SPDX-License-Identifier: Apache-2.0
"""Foundations without domain knowledge: units, errors, names, kernels, tables, formulas."""
