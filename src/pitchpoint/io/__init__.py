# SPDX-License-Identifier: Apache-2.0
"""Reading and writing of files: models, results, measurements, drawings."""
