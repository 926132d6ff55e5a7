# SPDX-License-Identifier: Apache-2.0
"""FMI functions: C sources, their translation to LLVM text, and the program that makes it."""
