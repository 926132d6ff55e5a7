# SPDX-License-Identifier: Apache-2.0
"""Plain data to components: the reader, and readers of values with a form of their own."""
