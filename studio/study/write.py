"""The files that come of a study: table, picture and recording, and the figure for a paper."""

from collections.abc import Sequence
from pathlib import Path

from studio.study.links import Links
from studio.study.picture.finding import compose_finding
from studio.study.picture.page import compose_study_picture
from studio.study.recording.write import write_study_recording
from studio.study.results import StudyResults
from studio.study.run import write_table


def write_study(
    files: Sequence[Path], papers: Sequence[Path], results: StudyResults, bank: str, links: Links
) -> str:
    """Write a study's table, its finding, recording, second picture, and its figures for papers.

    The files are in this order. The bank is given by its name, and the links lead to recordings of
    its scenes. What comes back is the caption of the figures; it is empty if there are none.
    """
    parquet, first, rrd, second = files
    write_table(parquet, results.table)
    compose_finding(results).save(first)
    compose_study_picture(results).save(second)
    write_study_recording(rrd, results, {"outcomes": bank}, links)
    caption = ""
    for paper in papers:
        # not everybody has matplotlib, which draws this figure alone
        from studio.study.paper.figure import write_paper_figure

        caption = write_paper_figure(paper, results)
    return caption
