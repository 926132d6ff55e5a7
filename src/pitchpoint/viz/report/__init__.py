# SPDX-License-Identifier: Apache-2.0
"""The page of a report: its frame and its sections."""
