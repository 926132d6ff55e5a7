# SPDX-License-Identifier: Apache-2.0
"""Static equilibrium: unknowns, iteration, closed loops, force jumps, diagnosis of failures."""
