# SPDX-License-Identifier: Apache-2.0
"""Translate the FMI functions from C to LLVM text, one text for all 64-bit targets: `make glue`.

Run after an edit of the C files; needs the extra `fmi` (ziglang). The text is part of the package, so that an
export needs no compiler. Attributes of one processor or system are removed; the exporter adds those of the
target.
"""

from __future__ import annotations

import hashlib
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
OPTIONS = (
    *("-target", "x86_64-linux-musl", "-O1", "-g0", "-S", "-emit-llvm", "-w"),
    *(
        "-ffp-contract=off",
        "-fno-sanitize=all",
        "-fno-stack-protector",
        "-fno-builtin",
        "-fno-vectorize",
        "-fno-inline",
        "-fno-strict-aliasing",
    ),
)
#: Attributes of one target, and those that older versions of LLVM do not know.
LEFT_OUT = re.compile(
    r", !(tbaa|tbaa\.struct|srcloc|llvm\.\w+) !\d+"
    r"| (uwtable|dso_local|noundef|nonnull|nocapture|readonly|writeonly)\b"
    r"| captures\([^)]*\)| dead_on_unwind\b| (?<=trunc )(nuw|nsw)( nsw)?|(?<=inbounds) nuw|(?<=zext) nneg"
    r"| initializes\(\([-\d, ()]*?\)\)| *; preds = .*$|(?<=or) disjoint|(?<=icmp) samesign| range\([^)]*\)"
)
GROUP = re.compile(r"^(attributes #\d+ =).*$", re.MULTILINE)


def sources_hash() -> str:
    """Hash of the C files."""
    digest = hashlib.sha256()
    for path in sorted([*HERE.glob("*.c"), *HERE.glob("*.h")]):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def translate(version: int) -> str:
    """LLVM text of the functions of one version of FMI, after a line with the hash of the C files."""
    source = HERE / f"fmi{version}.c"
    with tempfile.TemporaryDirectory() as folder:
        raw_file = Path(folder, "raw.ll")
        command = [sys.executable, "-m", "ziglang", "cc", *OPTIONS, "-o", str(raw_file), str(source)]
        subprocess.run(command, check=True)
        raw = raw_file.read_text(encoding="utf-8")
    lines = [
        LEFT_OUT.sub("", line)
        for line in GROUP.sub(r'\1 { nounwind "no-builtins" }', raw).splitlines()
        if not line.startswith(("target ", "!", "source_filename", ";")) and "@llvm.lifetime" not in line
    ]
    return "\n".join([f"; {sources_hash()}", *lines]) + "\n"


def main() -> None:
    """Write the texts of all versions."""
    for version in (2, 3):
        (HERE / f"fmi{version}.ll").write_text(translate(version), encoding="utf-8")


if __name__ == "__main__":
    main()
