# SPDX-License-Identifier: Apache-2.0
"""Diagnosis of a record: reading of file and machine, findings in words, HTML page."""
