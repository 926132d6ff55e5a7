# SPDX-License-Identifier: Apache-2.0
"""Bodies, joints, tree kinematics, inertia and constraints: numbers only."""
