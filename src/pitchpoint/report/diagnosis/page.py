# SPDX-License-Identifier: Apache-2.0
"""A diagnosis as one HTML page: the answer, what it rests on, and pictures of the evidence."""

from __future__ import annotations

from html import escape
from pathlib import Path

from pitchpoint import __version__
from pitchpoint.report.diagnosis import tables
from pitchpoint.report.diagnosis.pictures import add_channel
from pitchpoint.report.diagnosis.study import Study
from pitchpoint.report.diagnosis.words import percent
from pitchpoint.viz.report.page import Section, page

MOST_CHANNELS = 3
NOT_HEALTHY = (
    "This does not state that the machine is healthy: a fault that is smaller than the limits below stays "
    "unseen. The pictures show what comes nearest to a finding."
)


def diagnosis_page(study: Study) -> str:
    """The page about one study, as HTML; the same study gives the same characters.

    Parameters
    ----------
    study
        What `diagnose_file` found.
    """
    sections = [_answer(study), _assumed(study)]
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
    """Channels with findings, the most certain first; the one that comes nearest to a finding if none has."""
    found = dict.fromkeys(finding.channel for finding in study.diagnosis.findings)
    if found:
        return list(found)[:MOST_CHANNELS]
    evidence = study.diagnosis.evidence
    return [min(evidence, key=lambda e: (e.probability, e.threshold - e.value)).channel]


def _answer(study: Study) -> Section:
    """Findings in sentences, with the tooth where one stands out."""
    section = Section("answer", "Answer")
    places = study.place_sentences or ("",) * len(study.sentences)
    for number, words in enumerate(study.sentences):
        section.add(f"<p><b>{escape(_capital(words))}.</b></p>")
        place = places[number] if number < len(places) else ""
        section.add(f"<p>{escape(_capital(place))}.</p>" if place else "")
    if not study.diagnosis.findings:
        section.add(f"<p>{NOT_HEALTHY}</p>")
    found = study.diagnosis
    for words, texts in (
        ("Stands out, but is not a finding:", found.unreported),
        ("Not tested, so that nothing is known of it:", found.untested),
    ):
        items = "".join(f"<li>{escape(text)}</li>" for text in texts)
        section.add(f'<p>{words}</p><ul class="notes">{items}</ul>' if texts else "")
    return section


def _assumed(study: Study) -> Section:
    """Where each number comes from, and what turns how often."""
    section = Section("machine", "What was taken, and from where")
    section.add(tables.origin_table(study))
    section.add("<h3>What turns</h3>")
    section.add(tables.shaft_table(study))
    section.add(tables.mesh_table(study))
    section.add(tables.bearing_table(study))
    return section


def _tests(study: Study) -> Section:
    section = Section("tests", "All tests")
    section.add(
        f"<p>{study.diagnosis.tests} tests share the false alarms: "
        f"{percent(study.diagnosis.false_alarm)} of healthy records have a finding. “By chance” is the "
        "probability that any of the tests of a healthy record shows as much. A comb is given in standard "
        "deviations of a rank test, lines in decibels over what lies next to them.</p>"
    )
    section.add(tables.test_table(study))
    return section


def _limits(study: Study) -> Section:
    """What a fault would have to be like; only where there is none."""
    section = Section("limits", "What would have been found")
    if study.diagnosis.findings:
        return section
    (channel,) = shown_channels(study)
    section.add(
        f"<p>{escape(channel)}: faults are reported from these limits on. Lines below 1 % of the rms of the "
        "channel, and sidebands below 3 % of their mesh line, are never reported: every machine has "
        "them. A local fault must raise the orders of its shaft together, and strike at one place of the "
        "mean turn: the kurtosis of its residual must exceed 3 and the limit in the table of indicators.</p>"
    )
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
