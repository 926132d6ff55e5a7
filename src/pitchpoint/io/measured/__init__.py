# SPDX-License-Identifier: Apache-2.0
"""Measured files: one small file per format, one door (`reading.read_measured`) to all of them.

A format gives a `record.Record`, the contents of the file and nothing more; `assembly` checks it and makes
the dataset.
"""
