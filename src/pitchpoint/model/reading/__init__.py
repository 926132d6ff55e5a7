# SPDX-License-Identifier: Apache-2.0
"""Conversion of plain data to components: the reader, and readers of special values."""
