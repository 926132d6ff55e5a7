# SPDX-License-Identifier: Apache-2.0
"""Conversion of a REXS model to the data of a model file, one file per kind of part."""
