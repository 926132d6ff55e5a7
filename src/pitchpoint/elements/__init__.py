# SPDX-License-Identifier: Apache-2.0
"""Force elements: numeric records and compiled kernels that are called by address."""
