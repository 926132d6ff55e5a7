# SPDX-License-Identifier: Apache-2.0
"""Pages in a real browser, which all files of this folder share as long as they run one after the other."""
