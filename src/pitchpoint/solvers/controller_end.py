# SPDX-License-Identifier: Apache-2.0
"""End of sampled controllers whose run a program advances: by `close`, a context, or with the object."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, Self

if TYPE_CHECKING:
    from pitchpoint.solvers.sampled_control import Sampler


class EndsControllers:
    """Base of an object with sampled controllers, which have processes and files until they end."""

    _end_of_controllers: weakref.finalize | None = None

    def _end_with(self, sampler: Sampler | None) -> None:
        """End these controllers with `close`, at the end of a context, with the object, or with Python."""
        if sampler is not None:
            self._end_of_controllers = weakref.finalize(self, sampler.close)

    @property
    def closed(self) -> bool:
        """Whether the controllers have ended."""
        return self._end_of_controllers is not None and not self._end_of_controllers.alive

    def close(self) -> None:
        """End the controllers: libraries get their last call, and all processes end."""
        if self._end_of_controllers is not None:
            self._end_of_controllers()

    def __enter__(self) -> Self:
        """Return the object."""
        return self

    def __exit__(self, *_: object) -> None:
        """Close the object."""
        self.close()
