# SPDX-License-Identifier: Apache-2.0
"""Ground rules without domain knowledge: units, errors, names, kernels, tables, formulas."""
