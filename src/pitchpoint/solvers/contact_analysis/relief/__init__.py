# SPDX-License-Identifier: Apache-2.0
"""Relief design: flank modifications of least peak-to-peak transmission error over a range of torques."""
