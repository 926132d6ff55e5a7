# SPDX-License-Identifier: Apache-2.0
"""Equilibrium, quasi-static, modal and time solvers; the only place with time loops."""
