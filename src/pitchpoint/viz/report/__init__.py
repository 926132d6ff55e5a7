# SPDX-License-Identifier: Apache-2.0
"""HTML page of a report: frame and sections."""
