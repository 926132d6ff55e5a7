# SPDX-License-Identifier: Apache-2.0
"""HTML page of a diagnosis: result, data used, plots of the evidence, all tests, detection limits."""

from __future__ import annotations

from html import escape
from pathlib import Path

from pitchpoint import __version__
from pitchpoint.report.diagnosis import tables
from pitchpoint.report.diagnosis.change_page import change_section
from pitchpoint.report.diagnosis.change_words import change_sentences
from pitchpoint.report.diagnosis.pictures import add_channel, add_speed
from pitchpoint.report.diagnosis.study import Study
from pitchpoint.report.diagnosis.words import percent
from pitchpoint.viz.report.page import Section, page

MAX_CHANNELS = 3
NOT_HEALTHY = (
    "This does not prove that the machine is healthy: a fault below the detection limits given below is not "
    "detected. The plots show the evidence that is closest to a finding."
)

OF_GEARS = (
    "Lines below 1 % of the rms of the channel and sidebands below 3 % of their mesh line are never "
    "reported, because every machine has them. A local fault must raise all orders of its shaft and act at "
    "one angle of the synchronous average: the kurtosis of its residual must exceed 4 and the limit in the "
    "table of indicators."
)
OF_BEARINGS = (
    "The first three harmonics of a damaged part, five of a cage, must be this far above the surroundings in "
    "the squared envelope spectrum. Raised orders of shafts are observations."
)


def diagnosis_page(study: Study) -> str:
    """HTML page of one study; the same study gives the same text.

    Parameters
    ----------
    study
        Result of `diagnose_file`.
    """
    compared = [] if study.change is None else [change_section(study.change)]
    sections = [_answer(study), *compared, _assumed(study)]
    for number, channel in enumerate(shown_channels(study)):
        section = Section(f"channel-{number + 1}", f"Channel {channel}")
        add_channel(section, study, channel)
        sections.append(section)
    sections += [_tests(study), _limits(study), _remarks(study)]
    about = {row[0]: row for row in study.origin}
    facts = [
        ("file", Path(study.file).name),
        *((key, about[key][1]) for key in ("sample rate", "length", "speed") if key in about),
        ("version", __version__),
    ]
    return page(
        f"Diagnosis of {Path(study.file).name}", facts, sections, f"Made by pitchpoint {__version__}."
    )


def shown_channels(study: Study) -> list[str]:
    """Channels with findings, the most certain first; without findings the channel closest to one."""
    found = dict.fromkeys(finding.channel for finding in study.diagnosis.findings)
    if found:
        return list(found)[:MAX_CHANNELS]
    evidence = study.diagnosis.evidence
    return [min(evidence, key=lambda e: (e.probability, e.threshold - e.value)).channel]


def _answer(study: Study) -> Section:
    """Findings in sentences, with the tooth if one stands out."""
    section = Section("answer", "Result")
    for number, words in enumerate(study.sentences):
        # what is found in bold type, not its evidence
        part, seen, evidence = _capital(words).partition(", seen in ")
        rest = f"</b>{escape(seen + evidence)}." if seen else ".</b>"
        section.add(f"<p><b>{escape(part)}{rest}</p>")
        for detail in study.details(number):
            section.add(f"<p>{escape(_capital(detail))}.</p>")
    if study.change is not None and study.diagnosis.findings:
        words = change_sentences(study.change)[0]
        section.add(f"<p><b>{escape(_capital(words))}.</b></p>")
    if not study.diagnosis.findings:
        section.add(f"<p>{NOT_HEALTHY}</p>")
    found = study.diagnosis
    rated = [row.sentence for row in study.severity if not row.is_verdict]
    for words, texts in (
        ("Vibration of the machine:", rated),
        ("Observed, as on sound machines; no verdict from one record:", study.observed),
        ("Above the limit, but not a finding:", found.unreported),
        ("Not tested:", found.untested),
    ):
        items = "".join(f"<li>{escape(text)}</li>" for text in texts)
        section.add(f'<p>{words}</p><ul class="notes">{items}</ul>' if texts else "")
    return section


def _assumed(study: Study) -> Section:
    """Origin of the data, and the rotating parts with their rates."""
    section = Section("machine", "Data used")
    section.add(tables.origin_table(study))
    section.add("<h3>Rotating parts</h3>")
    section.add(tables.shaft_table(study))
    section.add(tables.mesh_table(study))
    section.add(tables.bearing_table(study))
    add_speed(section, study, shown_channels(study)[0])
    return section


def _tests(study: Study) -> Section:
    section = Section("tests", "All tests")
    section.add(
        f"<p>The limits of the {study.diagnosis.tests} tests are exceeded in at most "
        f"{percent(study.diagnosis.false_alarm)} of records of noise alone. Those of bearing parts are "
        "higher if they were counted on real machines. “By noise” is the probability that noise "
        "alone reaches this value in a test of the channel. Combs and periods are rated in "
        "standard deviations, lines in decibels above the adjacent spectrum. “Result” gives the reason "
        "if a value above its limit is not a finding.</p>"
    )
    section.add(tables.test_table(study))
    return section


def _limits(study: Study) -> Section:
    """Detection limits, for a record without findings."""
    section = Section("limits", "Detection limits")
    if study.diagnosis.findings:
        return section
    (channel,) = shown_channels(study)
    more = OF_GEARS if study.parts.meshes else OF_BEARINGS if study.parts.bearings else ""
    section.add(f"<p>{escape(channel)}: faults above these limits are reported. {more}</p>")
    section.add(tables.limit_table(study, channel))
    return section


def _remarks(study: Study) -> Section:
    section = Section("remarks", "Notes")
    if study.remarks:
        items = "".join(f"<li>{escape(text)}</li>" for text in study.remarks)
        section.add(f'<ul class="notes">{items}</ul>')
    return section


def _capital(words: str) -> str:
    return words[:1].upper() + words[1:]
