# SPDX-License-Identifier: Apache-2.0
"""Signal analysis of measured and simulated records: spectra, orders, indicators, diagnosis."""
