# SPDX-License-Identifier: Apache-2.0
"""Plots, drawings and reports of results; the only package that defines colours."""
