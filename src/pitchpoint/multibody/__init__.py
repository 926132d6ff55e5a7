# SPDX-License-Identifier: Apache-2.0
"""Numerical kernels of multibody dynamics: bodies, joints, tree kinematics, inertia and constraints."""
