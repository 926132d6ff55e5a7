# SPDX-License-Identifier: Apache-2.0
"""Everything between a kernel and its machine code."""
