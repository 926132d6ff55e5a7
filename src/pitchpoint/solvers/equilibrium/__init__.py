# SPDX-License-Identifier: Apache-2.0
"""Static equilibrium: unknowns, iteration, closed loops, force jumps, reasons why there is none."""
