# SPDX-License-Identifier: Apache-2.0
"""Measured files: one module per format, with the common entry point `reading.read_measured`.

A format module returns the contents of the file as a `record.Record`; `assembly` checks it and creates the
dataset.
"""
