# SPDX-License-Identifier: Apache-2.0
"""Finite elements of teeth and gear body, condensed to the flanks."""
