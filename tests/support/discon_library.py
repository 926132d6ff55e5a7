# SPDX-License-Identifier: Apache-2.0
"""A controller library with the interface of Bladed, compiled from C; its input file selects what it does."""

from __future__ import annotations

import functools
import shutil
import subprocess
import tempfile
from pathlib import Path

import pytest

SOURCE = r"""
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static double integral = 0.0;
static int calls = 0;

/* everything that arrives, in the order of the calls */
static void dump(const float *r, const char *in, const char *out)
{
    char name[600];
    FILE *file;
    snprintf(name, sizeof name, "%s.bin", calls == 1 ? out : "next");
    file = fopen(name, calls == 1 ? "wb" : "ab");
    fwrite(r, sizeof(float), 3300, file);
    fclose(file);
    file = fopen("texts", "wb");
    fprintf(file, "%s|%s", in, out);
    fclose(file);
}

void DISCON(float *r, int *fail, const char *in, char *out, char *message)
{
    int k;
    char what[600];
    strncpy(what, in, sizeof what - 1);
    calls++;
    if (strcmp(what, "all.in") == 0) {
        dump(r, in, out);
        for (k = 0; k < 3300; k++)
            r[k] = 5000.0f + k;
        r[54] = r[55] = 0.0f; /* overrides */
    } else if (strcmp(what, "count.in") == 0) {
        r[46] = (float)calls;
        r[44] = 0.25f * r[19];
    } else if (strcmp(what, "pi.in") == 0) { /* overspeed to pitch */
        double error = (double)r[19] - 100.0, demand;
        integral += 0.02 * (double)r[2] * error;
        demand = 0.05 * error + integral;
        r[44] = (float)(demand < 0.0 ? 0.0 : demand > 1.5 ? 1.5 : demand);
    } else if (strcmp(what, "individual.in") == 0) { /* each blade by its root moment */
        for (k = 0; k < 3; k++)
            r[41 + k] = r[27] * (0.1f + 2e-3f * r[29 + k] + 0.5f * r[k == 0 ? 3 : 31 + k]);
    } else if (strcmp(what, "late.in") == 0 && r[1] < 0.045f) {
        r[46] = 1.0f;
    } else if (strcmp(what, "crash.in") == 0 || strcmp(what, "late.in") == 0) {
        printf("last words\n");
        fflush(stdout);
        *(volatile int *)0 = 1;
    } else if (strcmp(what, "hang.in") == 0) {
        for (;;)
            sleep(1);
    } else if (strcmp(what, "exit.in") == 0) {
        exit(3);
    } else if (strcmp(what, "nan.in") == 0) {
        r[46] = NAN;
    } else if (strcmp(what, "fail.in") == 0) {
        strcpy(message, "the table of gains is empty");
        *fail = -1;
    } else if (strcmp(what, "warn.in") == 0) {
        strcpy(message, "speed above the table");
        *fail = 1;
        r[46] = 2.0f;
    } else if (strcmp(what, "override.in") == 0) {
        r[54] = 1.0f;
    } else if (strcmp(what, "last.in") == 0 && r[0] < 0.0f) {
        strcpy(message, "cannot write the log");
        *fail = -2;
    }
}
"""


@functools.cache
def discon_library() -> Path:
    """The library, compiled once; skips the test without a C compiler."""
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        pytest.skip("no C compiler (cc, gcc, clang) for the controller library of the test")
    folder = Path(tempfile.mkdtemp(prefix="discon"))
    (folder / "probe.c").write_text(SOURCE, encoding="utf-8")
    library = folder / "libprobe.so"
    subprocess.run(
        [compiler, "-shared", "-fPIC", "-O1", "-o", library, folder / "probe.c", "-lm"], check=True
    )
    return library


def input_file(folder: Path, what: str) -> Path:
    """Input file that lets the library do something, such as `crash`."""
    file = folder / f"{what}.in"
    file.touch()
    return file


def processes_of_controllers() -> list[str]:
    """Processes of controllers that run now, with this library or one in the working directory."""
    listed = subprocess.run(["ps", "-ww", "-eo", "pid,args"], capture_output=True, text=True, check=True)
    mine = (str(discon_library()), str(Path.cwd() / "libprobe.so"))
    lines = listed.stdout.splitlines()
    return [line for line in lines if "host.py" in line and any(library in line for library in mine)]
