# SPDX-License-Identifier: Apache-2.0
"""Equilibrium, quasi-static, modal and time solvers. All time loops of the package are here."""
