# SPDX-License-Identifier: Apache-2.0
"""Storage of a study: a folder of cases, each a JSON file with the numbers of all its results."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from typing import Any

from pitchpoint.io.case_folder import CaseFolder

TABLE = "study.h5"
PAGE = "study.html"


class StudyFolder(CaseFolder):
    """Folder of a study."""

    suffix = ".json"
    products = frozenset({TABLE, PAGE})

    def known(self, keys: Iterable[str]) -> dict[str, dict[str, Any]]:
        """Records of the complete files of some cases, as given to `write`."""
        found = {}
        for key, data in self.contents(keys):
            record = json.loads(bytes(data))
            record["numbers"] = {
                name: [math.nan if x is None else x for x in row] for name, row in record["numbers"].items()
            }
            found[key] = record
        return found

    def write(self, key: str, record: Mapping[str, Any]) -> None:
        """Write a case: status, sentence, steps, notes, changes, and the numbers of all results by name."""
        numbers = {
            name: [x if math.isfinite(x) else None for x in row] for name, row in record["numbers"].items()
        }
        text = json.dumps({**record, "numbers": numbers}, sort_keys=True, allow_nan=False, indent=0)
        self.put_case(key, text.encode())
