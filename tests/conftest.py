# SPDX-License-Identifier: Apache-2.0
"""Shared set-up of all tests: markers from folders, Hypothesis profiles, what keeps runs short."""

from __future__ import annotations

import gc
import itertools
import os
import signal
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import HealthCheck, settings

if TYPE_CHECKING:
    from pitchpoint.core.progress import Progress

TESTS = Path(__file__).parent
LONG = ("tests/browser/", "tests/examples/", "tests/validation/")
"""Folders with the longest files."""
BACKWARDS = os.environ.get("PYTEST_XDIST_WORKER", "")[-1:] in tuple("13579")
"""Whether this is every second worker."""

TEXTS, LARGE = 100, 100_000
"""Number of model texts whose nodes are kept, and the number of characters above which they are not."""
FEW_SETS = 12
"""Number of parameter sets of a test up to which all are in `make test`."""

# Before anybody loads NumPy: tests run side by side already, and threads of its linear algebra that share
# processors spend most of their time waiting for each other (modes of 300 discs: a third of the time).
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

# The shared profile is reproducible and short; `HYPOTHESIS_PROFILE=long` searches further.
_SLOW_IS_FINE = [HealthCheck.too_slow, HealthCheck.filter_too_much]
settings.register_profile(
    "ci", max_examples=60, derandomize=True, deadline=None, suppress_health_check=_SLOW_IS_FINE, database=None
)
settings.register_profile("long", max_examples=2000, deadline=None, suppress_health_check=_SLOW_IS_FINE)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "ci"))

# A shell in the background, or nohup, lets its children ignore these signals, and they inherit that in turn.
for number in (signal.SIGINT, signal.SIGHUP):
    if signal.getsignal(number) is signal.SIG_IGN:
        signal.signal(number, signal.default_int_handler if number == signal.SIGINT else signal.SIG_DFL)


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """A run without the compiler, or with the stock one, imports only the files that have tests for it."""
    marker = config.option.markexpr
    if marker in ("nojit", "stock") and collection_path.name.startswith("test_"):
        return f"mark.{marker}" not in collection_path.read_text(encoding="utf-8") or None
    return None


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(
    collector: pytest.Collector,
) -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    """Every second worker collects backwards, so that each rewrites the assertions of half of the new files.

    Both read the other half from the cache. The order of the tests does not depend on it.
    """
    report = yield
    if BACKWARDS and isinstance(collector, (pytest.Dir, pytest.Package)):
        report.result.reverse()
    return report


def pytest_addoption(parser: pytest.Parser) -> None:
    """Option of short runs: `--thin 8` runs at most eight parameter sets of each test function."""
    parser.addoption(
        "--thin", type=int, help="parameter sets per test function, evenly spread; all if omitted"
    )


def pytest_collection_finish() -> None:
    """What the collection made stays to the end: nobody need look through it for rubbish again and again."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(50_000, 20, 20)  # as in the command line; syntax trees are read four times as fast
    remember_nodes()


def remember_nodes() -> None:
    """Keep the nodes of the last model texts: ruamel.yaml takes most of the time of reading a model."""
    from pitchpoint.model.reading import yaml_tree

    compose = yaml_tree._compose
    kept: dict[str, Any] = {}

    def composed(text: str, progress: Progress = yaml_tree.silent) -> Any:
        """Nodes of a text, which `Tree` does not change."""
        if len(text) > LARGE:  # a test may observe how they are composed
            return compose(text, progress)
        if text not in kept:
            kept[text] = compose(text, progress)
            while len(kept) > TEXTS:
                del kept[next(iter(kept))]
        return kept[text]

    yaml_tree._compose = composed


@pytest.hookimpl(wrapper=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> Iterator[None]:
    """Every test carries the name of its folder as marker; `--thin` counts what is selected.

    Of tests over three parameters and more `make test` has every pair of values, of those with the marker
    `each_value` every value; other sets are studies.
    The longest files are first: a long file that is started last leaves one worker without work.
    """
    for item in items:
        try:
            folder = item.path.relative_to(TESTS).parts[0]
        except ValueError:
            continue
        if not folder.endswith(".py"):
            item.add_marker(folder)
    for sets in by_function(items).values():
        every = sets[0].get_closest_marker("each_value") is not None
        if every or len(sets) > FEW_SETS:
            for item in beyond(sets, 1 if every else 2):
                item.add_marker("study")
    yield
    items.sort(key=place)
    if config.option.thin:
        kept = thinned(items, config.option.thin)
        config.hook.pytest_deselected(items=[item for item in items if item not in kept])
        items[:] = [item for item in items if item in kept]


def place(item: pytest.Item) -> tuple[bool, bool, str]:
    """Sort key: longest folders, other tests, examples in docstrings, each by file."""
    file = item.nodeid.partition("::")[0]
    return not file.startswith(LONG), not file.startswith("tests/"), file


def thinned(items: list[pytest.Item], most: int) -> set[pytest.Item]:
    """At most so many parameter sets of each test function, evenly spread, first and last among them."""
    kept: set[pytest.Item] = set()
    for sets in by_function(items).values():
        number = min(most, len(sets))
        kept |= {sets[k * (len(sets) - 1) // max(number - 1, 1)] for k in range(number)}
    return kept


def by_function(items: list[pytest.Item]) -> dict[str, list[pytest.Item]]:
    """Parameter sets of each test function."""
    functions: dict[str, list[pytest.Item]] = {}
    for item in items:
        functions.setdefault(item.nodeid.partition("[")[0], []).append(item)
    return functions


def beyond(sets: list[pytest.Item], strength: int) -> list[pytest.Item]:
    """Sets whose values are in other sets, alone (strength 1) or in pairs (2).

    Two parameters in one list of sets count as one. The order of the search is scattered but fixed.
    """
    seen: set[object] = set()
    left = []
    for k in sorted(range(len(sets)), key=lambda k: k * 7919 % 10007):
        values = enumerate(sets[k].callspec._idlist)  # one name per list of values
        found = set(itertools.combinations(values, strength))
        if len(sets[k].callspec._idlist) > strength and found <= seen:
            left.append(sets[k])
        seen |= found
    return left
