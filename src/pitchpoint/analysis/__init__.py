# SPDX-License-Identifier: Apache-2.0
"""From signals to numbers, measured or simulated: spectra, orders, jumps, amplification."""
