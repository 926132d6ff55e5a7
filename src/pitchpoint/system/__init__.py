# SPDX-License-Identifier: Apache-2.0
"""Where a description becomes arrays: layout, records, residual, observation."""
