# SPDX-License-Identifier: Apache-2.0
"""Statistics of studies: spread of results over samples of their factors, yield, sensitivities."""
