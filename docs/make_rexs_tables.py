# SPDX-License-Identifier: Apache-2.0
"""Write the tables of REXS ids from the official schema files: `make_rexs_tables.py FOLDER`.

FOLDER contains rexs_schema_1.0.xml.gz to rexs_schema_2.0.0.xml.gz of `fva-net/rexs-api-java` (Apache-2.0, FVA
GmbH). For a new version add it to `VERSIONS`, here and in `pitchpoint.io.rexs.tables`.
"""

from __future__ import annotations

import csv
import gzip
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

VERSIONS = ("1.0", "1.1", "1.2", "1.3", "1.4", "1.5", "1.6", "1.7", "2.0.0")
TARGET = Path(__file__).parents[1] / "src" / "pitchpoint" / "io" / "rexs"
NOTICE = "ids, units and value types of the REXS schemas 1.0 to 2.0.0 of FVA GmbH (www.rexs.info); Apache-2.0"


def schema(
    folder: Path, version: str
) -> tuple[dict[int, str], dict[int, tuple[str, str, str]], dict[int, set]]:
    """Components, attributes (id, unit, value type) and components of every attribute, by number."""
    with gzip.open(folder / f"rexs_schema_{version}.xml.gz") as file:
        root = ET.parse(file).getroot()
    named = {kind: {x.get("id"): x.get("name") for x in root.find(kind)} for kind in ("units", "valueTypes")}
    components = {int(x.get("numericId")): x.get("componentId") for x in root.find("components")}
    attributes = {
        int(x.get("numericId")): (
            x.get("attributeId"),
            named["units"][x.get("unit")],
            named["valueTypes"][x.get("valueType")],
        )
        for x in root.find("attributes")
    }
    numbers = {name: number for number, name in components.items()}
    places: dict[int, set] = {}
    for x in root.find("componentAttributeMappings"):
        places.setdefault(int(x.get("attributeNumericId")), set()).add(numbers[x.get("componentId")])
    return components, attributes, places


def spans(found: dict[str, dict[int, tuple]]) -> list[tuple[int, tuple, str, str]]:
    """Number, data, first and last version of data that do not change in between."""
    rows = []
    for number in sorted({n for table in found.values() for n in table}):
        for version in VERSIONS:
            data = found[version].get(number)
            if data is None:
                continue
            if rows and rows[-1][0] == number and rows[-1][1] == data:
                rows[-1] = (*rows[-1][:3], version)
            else:
                rows.append((number, data, version, version))
    return rows


def main(folder: Path) -> None:
    """Write both tables."""
    read = {version: schema(folder, version) for version in VERSIONS}
    components = spans({v: {n: (name,) for n, name in data[0].items()} for v, data in read.items()})
    attributes = spans({v: data[1] for v, data in read.items()})
    with (TARGET / "components.csv").open("w", encoding="utf-8", newline="") as file:
        write = csv.writer(file, lineterminator="\n").writerow
        write([f"# {NOTICE}"])
        write(["number", "id", "since", "until"])
        for number, (name,), since, until in components:
            write([number, name, since, until])
    with (TARGET / "attributes.csv").open("w", encoding="utf-8", newline="") as file:
        write = csv.writer(file, lineterminator="\n").writerow
        write([f"# {NOTICE}"])
        write(["number", "id", "unit", "type", "since", "until", "components"])
        for number, data, since, until in attributes:
            within = VERSIONS[VERSIONS.index(since) : VERSIONS.index(until) + 1]
            places = sorted(set().union(*(read[v][2].get(number, set()) for v in within)))
            write([number, *data, since, until, " ".join(map(str, places))])


if __name__ == "__main__":
    main(Path(sys.argv[1]))
