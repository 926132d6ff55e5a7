# SPDX-License-Identifier: Apache-2.0
"""Model reduction: selection of the condensed parts, condensation, error of the result."""
