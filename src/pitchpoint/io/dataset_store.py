# SPDX-License-Identifier: Apache-2.0
"""Storage of a data set: a folder of cases, each a file with the time series of its channels."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable
from typing import Any

from pitchpoint.core.status import OK
from pitchpoint.io.case_folder import DRAFT, CaseFolder
from pitchpoint.io.container import FAILED, FINISHED, Header, MemoryContainer
from pitchpoint.io.reading import header_in
from pitchpoint.io.unmarked_file import DAMAGE

_ROWS = 8192


class DatasetFolder(CaseFolder):
    """Folder of a data set."""

    def known(self, keys: Iterable[str]) -> dict[str, dict[str, Any]]:
        """Metadata of the complete files of some cases: status, sentence, options."""
        import h5py

        found = {}
        for key, _ in self.contents(keys):
            with contextlib.suppress(*DAMAGE), h5py.File(self.file_of(key), "r") as file:
                found[key] = header_in(file)
        return found

    def write(self, record: Any, header: Header, sample_rate: float, samples: int) -> None:
        """Write one case: a `CaseRecord`, or anything with its attributes."""
        import numpy as np

        container = MemoryContainer(self.cases / f"{DRAFT}{record.key}", header)
        if record.channels:
            clock = {"units": "s", "long_name": "time", "symbol": "t"}
            time = container.dimension("time", np.arange(samples) / sample_rate, attributes=clock)
            for name, channel in record.channels.items():
                whole = np.issubdtype(channel.values.dtype, np.integer)
                made = container.variable(
                    name,
                    [time],
                    dtype="i1" if whole else "f4",
                    chunks=(min(_ROWS, samples),),
                    packed=True,
                    attributes={"units": channel.unit, "long_name": channel.long_name},
                )
                made[...] = channel.values
                made.attrs["noise_rms"] = channel.noise_rms
            for name, begun in record.pulses.items():
                words = {"units": "s", "long_name": f"times at which pulses of {name} begin"}
                container.dimension(f"{name}_times", begun, attributes=words)
        status = FINISHED if record.status == OK else FAILED
        container.finish(status, record.sentence, code=record.status, steps=record.steps, notes=record.notes)
        self.put_case(record.key, container.image)
