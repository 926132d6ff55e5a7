# SPDX-License-Identifier: Apache-2.0
"""Speed of pitchpoint, always as a ratio against a peer measured in the same run: `make bench`."""
