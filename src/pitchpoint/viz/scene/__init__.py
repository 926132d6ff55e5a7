# SPDX-License-Identifier: Apache-2.0
"""The 3-D scene as plain numbers, as a file and as a page."""
