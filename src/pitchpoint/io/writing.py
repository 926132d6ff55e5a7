# SPDX-License-Identifier: Apache-2.0
"""Streaming of time series to disk: blocks of decimated samples, with statistics of all samples.

A solver passes chunks of any size. The writer buffers at most one block, writes it as one chunk per channel
and flushes it: the memory does not grow with the length of the run. For samples omitted by decimation, the
minimum, maximum, mean and rms of every block at full rate are stored in the group `blocks`, and
`RunningStatistics` summarises the run.
"""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Self

from pitchpoint.core import status as st
from pitchpoint.core.errors import SolverError
from pitchpoint.core.nomenclature import symbol
from pitchpoint.io.contact_numbers import RATTLE
from pitchpoint.io.container import FAILED, FINISHED, INTERRUPTED, Container, Header, ResultError

if TYPE_CHECKING:
    from types import TracebackType

    import numpy as np

STATISTICS = ("min", "max", "mean", "rms")
BLOCK_GROUP = "blocks"
EVENT_GROUP = "events"

MAX_CHANNELS = 6000
"""Maximum number of channels: HDF5 fails in SWMR mode with 8000 channels of two variables each, and takes
minutes to close files well below this number."""

#: Numbers of the attribute `statistics` of a channel, in this order; `rms` of the alternating part.
RUN_STATISTICS = ("mean", "rms", "min", "max")


@dataclass(frozen=True)
class Channel:
    """Recorded quantity: `name` as in `mesh_force[stage]`, SI unit, description and symbol for axes.

    The default symbol is that of the nomenclature.
    Channels are stored as 32-bit floats (7 digits) unless `dtype` is given; angles of a shaft grow
    without limit, so they have 64 bits.
    """

    name: str
    unit: str
    long_name: str = ""
    symbol: str = ""
    dtype: str = ""

    @property
    def stored_as(self) -> str:
        """Storage type: the requested one, else float64 for angles and float32 for all others."""
        return self.dtype or ("f8" if self.name.startswith("angle[") else "f4")

    @property
    def attributes(self) -> dict[str, str]:
        """Attributes of the variable in the file."""
        words = self.long_name or self.name.partition("[")[0].replace("_", " ")
        return {"units": self.unit, "long_name": words, "symbol": self.symbol or symbol(self.name)}


class RunningStatistics:
    """Minimum, maximum, mean and rms of the alternating part, without storing the samples.

    Chunks are merged by their counts, means and sums of squared deviations, without loss of precision in long
    runs.

    Parameters
    ----------
    n_channels
        Number of channels.
    since
        Samples before this time are omitted [s].

    References
    ----------
    .. [1] Chan, Golub, LeVeque: Algorithms for computing the sample variance, The American Statistician 37
       (1983), equation 2.1b.
    """

    def __init__(self, n_channels: int, since: float = float("-inf")) -> None:
        import numpy as np

        self.since = since
        self.count = 0
        self.low = np.full(n_channels, np.inf)
        self.high = np.full(n_channels, -np.inf)
        self.mean = np.zeros(n_channels)
        self._squares = np.zeros(n_channels)

    def add(self, t: np.ndarray, values: np.ndarray) -> None:
        """Add samples, shapes (n,) and (n, n_channels), in the order of time."""
        import numpy as np

        if t.size and t[0] < self.since:
            values = values[int(np.searchsorted(t, self.since)) :]
        n = values.shape[0]
        if n == 0:
            return
        mean = values.mean(axis=0)
        total = self.count + n
        step = mean - self.mean
        self._squares += ((values - mean) ** 2).sum(axis=0) + step**2 * (self.count * n / total)
        self.mean += step * (n / total)
        self.count = total
        np.minimum(self.low, values.min(axis=0), out=self.low)
        np.maximum(self.high, values.max(axis=0), out=self.high)

    @property
    def rms(self) -> np.ndarray:
        """Rms of the alternating part, shape (n_channels,)."""
        import numpy as np

        return np.sqrt(self._squares / max(self.count, 1))


class Closing:
    """Store the exception that leaves a `with` block on a result file as its status."""

    finish: Callable[..., None]

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        status, sentence, code = how_it_ended(error)
        self.finish(status, sentence, code=code)


class ResultWriter(Closing):
    """Writer of the channels of one run to a file that can be read at any time.

    Parameters
    ----------
    path
        File to write (netCDF-4 in HDF5).
    header
        Provenance.
    channels
        Recorded quantities, in the order of the columns passed to `append`.
    block
        Rows per block and chunk: the data in memory, and the maximum loss if the process is killed.
    decimate
        Store every n-th sample; the statistics use all samples.
    since
        Start of the statistics window [s].
    events
        Names of the event functions whose roots are recorded, if any.

    Examples
    --------
    >>> import numpy as np, tempfile, pathlib
    >>> name = pathlib.Path(tempfile.mkdtemp()) / "run.h5"
    >>> with ResultWriter(name, Header("time"), [Channel("mesh_force[stage]", "N")]) as writer:
    ...     writer.append(np.array([0.0, 0.5]), np.array([[10.0], [30.0]]))
    >>> writer.statistics()["mesh_force[stage]"]
    {'unit': 'N', 'mean': 20.0, 'rms': 10.0, 'min': 10.0, 'max': 30.0}
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        header: Header,
        channels: Sequence[Channel],
        *,
        block: int = 4096,
        decimate: int = 1,
        since: float = float("-inf"),
        events: Sequence[str] = (),
    ) -> None:
        import numpy as np

        names = [c.name for c in channels]
        if len(set(names)) != len(names):
            raise ResultError("two channels have the same name; use unique names")
        if len(names) > MAX_CHANNELS:
            raise ResultError(
                f"{os.fspath(path)}: the run has {len(names)} channels, more than a result file takes (limit "
                f"{MAX_CHANNELS}); choose which to store: channels: ['mesh_force[*]'] in the scenario, or "
                "--channels 'mesh_force[*]'"
            )
        if block < 1 or decimate < 1:
            raise ResultError(f"block {block} and decimate {decimate} must be at least 1")
        self.channels = tuple(channels)
        self.decimate = int(decimate)
        block = -(-block // self.decimate) * self.decimate
        self._running = RunningStatistics(len(names), since)
        self._t = np.empty(block)
        self._values = np.empty((block, len(names)))
        self._filled = 0
        self._stored = 0
        self._seen = 0
        self._blocks = 0
        self._begun = time.perf_counter()
        self._container = Container(path, header, variables=2 * len(names) + 8)
        self._events: list[Any] = []
        with self._container.writing():
            self._make_variables(block)
            if events:
                self._make_events(events)
        self._container.begin()

    def _make_variables(self, block: int) -> None:
        # Complete chunks are compressed; shorter blocks after decimation fill their chunk in place.
        container, packed = self._container, block // self.decimate >= 64
        rows = max(block // self.decimate, 64)
        clock = {"units": "s", "long_name": "time", "symbol": "t"}
        self._time = container.dimension("time", unlimited=True, chunk=rows, packed=packed, attributes=clock)
        self._series = [
            container.variable(
                c.name,
                [self._time],
                dtype=c.stored_as,
                chunks=(rows,),
                packed=packed,
                attributes=c.attributes,
            )
            for c in self.channels
        ]
        for series in self._series:
            series.attrs["statistics"] = [math.nan] * len(RUN_STATISTICS)
        for channel, series in zip(self.channels, self._series, strict=True):
            if channel.name.startswith("contact_state["):
                series.attrs.update({name: math.nan for name, _, _ in RATTLE})
        statistic = container.dimension("statistic", STATISTICS, group=BLOCK_GROUP)
        start = {"units": "s", "long_name": "time of the first sample of the block", "symbol": "t"}
        self._block_time = container.dimension(
            "time", group=BLOCK_GROUP, unlimited=True, chunk=512, attributes=start
        )
        self._block_series = [
            container.variable(
                c.name,
                [self._block_time, statistic],
                group=BLOCK_GROUP,
                dtype=c.stored_as,
                chunks=(512, len(STATISTICS)),
                attributes=c.attributes,
            )
            for c in self.channels
        ]

    def _make_events(self, names: Sequence[str]) -> None:
        container = self._container
        clock = {"units": "s", "long_name": "time of the event", "symbol": "t"}
        when = container.dimension("time", group=EVENT_GROUP, unlimited=True, chunk=256, attributes=clock)
        which = {"long_name": "event function", "flag_meanings": " ".join(n.replace(" ", "_") for n in names)}
        way = {"long_name": "direction: 1 rising, -1 falling"}
        options: dict[str, Any] = {"group": EVENT_GROUP, "dtype": "i4", "chunks": (256,)}
        kind = container.variable("event", [when], attributes=which, **options)
        direction = container.variable("direction", [when], attributes=way, **options)
        kind.attrs["flag_values"] = list(range(len(names)))
        self._events = [kind, direction, when]

    def append_events(self, found: np.ndarray) -> None:
        """Add root events, shape (n, 3): time [s], index of the event function, direction (1 or -1)."""
        if not self._events or not len(found):
            return
        with self._container.writing():
            n = self._events[-1].shape[0] + len(found)
            for series, column in zip(self._events, (1, 2, 0), strict=True):
                series.resize((n,))
                series[n - len(found) :] = found[:, column]

    @property
    def path(self) -> str:
        """The file."""
        return str(self._container.path)

    @property
    def samples(self) -> int:
        """Number of added samples before decimation."""
        return self._seen

    def append(self, t: np.ndarray, values: np.ndarray) -> None:
        """Add samples: times, shape (n,) [s], and channels, shape (n, n_channels) [SI units]."""
        n, done, block = t.shape[0], 0, self._t.shape[0]
        self._running.add(t, values)
        while done < n:
            take = min(n - done, block - self._filled)
            rows = slice(self._filled, self._filled + take)
            self._t[rows] = t[done : done + take]
            self._values[rows] = values[done : done + take]
            self._filled += take
            done += take
            if self._filled == block:
                self.flush()

    def flush(self) -> None:
        """Write the buffered samples as a separate block."""
        n = self._filled
        if n == 0:
            return
        self._filled = 0
        with self._container.writing():
            self._write(self._t[:n], self._values[:n])
        self._container.flush()

    def _write(self, t: np.ndarray, values: np.ndarray) -> None:
        """Write one block of times, shape (n,), and values, shape (n, n_channels)."""
        import numpy as np

        n = t.shape[0]
        first = -self._seen % self.decimate
        self._seen += n
        keep = slice(first, None, self.decimate)
        added = t[keep].shape[0]
        if added:
            here = slice(self._stored, self._stored + added)
            self._stored += added
            for k, series in enumerate(self._series):
                series.resize((self._stored,))
                series[here] = values[keep, k]
            # Time is written last: no channel is shorter than `time` for a reader.
            self._time.resize((self._stored,))
            self._time[here] = t[keep]
        summary = np.stack([values.min(axis=0), values.max(axis=0), values.mean(axis=0), values.std(axis=0)])
        self._blocks += 1
        for k, series in enumerate(self._block_series):
            series.resize((self._blocks, len(STATISTICS)))
            series[self._blocks - 1] = summary[:, k]
        self._block_time.resize((self._blocks,))
        self._block_time[self._blocks - 1] = t[0]

    def statistics(self) -> dict[str, dict[str, Any]]:
        """Statistics of the samples since the start of the statistics window, by channel.

        `rms` is that of the alternating part; without a sample in the window every number is None.
        """
        run = self._running
        table = {}
        for k, channel in enumerate(self.channels):
            numbers = (run.mean[k], run.rms[k], run.low[k], run.high[k])
            row: dict[str, Any] = {"unit": channel.unit}
            for key, number in zip(RUN_STATISTICS, numbers, strict=True):
                row[key] = float(number) if run.count else None
            table[channel.name] = row
        return table

    def finish(
        self,
        status: str = FINISHED,
        sentence: str = "",
        *,
        code: int = st.OK,
        steps: int | None = None,
        wall_s: float | None = None,
        notes: Sequence[str] = (),
        statistics: Mapping[str, Mapping[str, Any]] | None = None,
    ) -> None:
        """Write remaining samples, status and notes; a second call has no effect.

        `statistics` by channel are those of all steps of the run; default: those of the samples. Contact
        states have the contact numbers of their mesh, too.
        """
        if not self._container.is_open:
            return
        self.flush()
        known = self.statistics() if statistics is None else statistics
        with self._container.writing():
            for channel, series in zip(self.channels, self._series, strict=True):
                numbers = [known[channel.name][key] for key in RUN_STATISTICS]
                series.attrs.modify("statistics", [math.nan if n is None else n for n in numbers])
                for name, _, _ in RATTLE:
                    if name in known[channel.name]:
                        series.attrs.modify(name, float(known[channel.name][name]))
        elapsed = time.perf_counter() - self._begun if wall_s is None else wall_s
        self._container.finish(
            status,
            sentence or st.sentence(code),
            code=code,
            steps=self._seen if steps is None else steps,
            wall_s=elapsed,
            notes=notes,
        )


def how_it_ended(error: BaseException | None) -> tuple[str, str, int]:
    """Status, sentence and integer status of a result file for the exception that left a `with` block."""
    if error is None:
        return FINISHED, st.sentence(st.OK), st.OK
    if isinstance(error, KeyboardInterrupt):
        return INTERRUPTED, st.sentence(st.INTERRUPTED), st.INTERRUPTED
    if isinstance(error, SolverError):
        return (INTERRUPTED if error.status == st.INTERRUPTED else FAILED), str(error), error.status
    return FAILED, f"{type(error).__name__}: {error}", st.DIED
