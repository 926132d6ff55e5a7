# SPDX-License-Identifier: Apache-2.0
"""Compilation of kernels to machine code, and its cache."""
