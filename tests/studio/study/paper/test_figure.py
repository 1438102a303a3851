"""The figure for a paper: what it looks like, and how a person gets it."""

import itertools
import re
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import matplotlib as mpl
import numpy as np
import pyarrow.parquet as pq
import pytest
from click.testing import Result
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from learners import PROFILES, TEACHERS, Teacher
from scenes.bank import BankPlan, write_bank
from studio.study.paper.figure import compose_paper_figure, write_paper_figure
from studio.study.paper.page import settings
from studio.study.results import StudyResults
from studio.study.words import paper_caption
from studio.style.palette import learner_colour
from tests.command_line import run
from tests.studio.study.tables import THREE, study_of

COLUMN = 89.0 / 25.4 * 72.0  # pt
SIZES = (25, 50, 100, 200, 500, 1000, 2000)


def case(
    teachers: tuple[Teacher, ...] = THREE,
    learners: Sequence[str] = ("eu", "cpt"),
    sizes: Sequence[int] = SIZES,
    seeds: int = 3,
    **columns: Any,
) -> StudyResults:
    known = {"certainty": 0.82} | columns
    return study_of(teachers, learners, sizes, seeds, **known)


def without_the_end(rows: int) -> StudyResults:
    table = case().table
    return StudyResults(table.slice(0, table.num_rows - rows), THREE)


OWN = tuple(
    Teacher(f"a-teacher-of-my-own-whose-name-is-too-long-for-a-column-{index}", PROFILES["tk"])
    for index in range(6)
)
ODD = Teacher("50$ & <more>$ 慎重\n\x01", PROFILES["strong"])
EVERYBODY = ("eu", "cpt", "cpt-tied", "cpt-reference", "cpt-tied-reference")
WORDY = ("eu", "a-learner-of-my-own-whose-name-is-too-long-for-a-column")

CASES: dict[str, Callable[[], StudyResults]] = {
    "three teachers": case,
    "one teacher": lambda: case(THREE[:1]),
    "two teachers": lambda: case(THREE[:2]),
    "six teachers": lambda: case(OWN, EVERYBODY),
    "five learners": lambda: case(THREE, EVERYBODY),
    "ten learners": lambda: case(THREE, [*EVERYBODY, *"abcde"]),
    "long names": lambda: case(OWN[:2], WORDY),
    "odd names": lambda: case((ODD,), ("cpt", "$x$")),
    "one learner": lambda: case(learners=("cpt",)),
    "one size": lambda: case(sizes=(100,)),
    "one fit": lambda: case(THREE[:1], ("cpt",), (100,), 1),
    "many sizes": lambda: case(sizes=range(100, 3100, 100)),
    "most sizes missing": lambda: without_the_end(80),
    "some seeds missing": lambda: without_the_end(8),
    "nobody fitted": lambda: without_the_end(126),
    "one teacher fitted": lambda: StudyResults(case(THREE[:1]).table, THREE),
    "no regret": lambda: case(regret_percent=0.0),
    "huge regret": lambda: case(regret_percent=123456.7),
    "tiny regret": lambda: case(regret_percent=1.5e-7),
}


def texts_of(figure: Figure) -> Iterator[Text]:
    yield from figure.texts
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            for tick in axis.get_major_ticks():
                if tick.label1.get_visible():
                    yield tick.label1


def placed_texts(figure: Figure) -> list[tuple[str, Bbox]]:
    """What is written in a figure, and where, pt."""
    figure.dpi = 720.0  # so that rounding to pixels does not count
    renderer = FigureCanvasAgg(figure).get_renderer()
    with settings():
        figure.draw_without_rendering()  # numbers beside axes are not there before
    return [
        (text.get_text(), Bbox(text.get_window_extent(renderer).get_points() / 10.0))
        for text in texts_of(figure)
        if text.get_text()
    ]


def said(figure: Figure) -> list[str]:
    return [text for text, _ in placed_texts(figure)]


def pixels_of(figure: Figure) -> np.ndarray[Any, Any]:
    canvas = FigureCanvasAgg(figure)
    figure.dpi = 300.0
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3]


@pytest.mark.filterwarnings("ignore:Glyph")  # texts are measured outside of the settings
@pytest.mark.parametrize("name", CASES)
def test_texts_can_be_read_and_stay_on_the_page_and_off_one_another(name: str) -> None:
    figure = compose_paper_figure(CASES[name]())
    placed = placed_texts(figure)
    width, height = 72.0 * figure.get_size_inches()
    assert width == pytest.approx(COLUMN)
    assert len(placed) > 5
    for text, box in placed:
        assert 0.0 <= box.x0 < box.x1 <= width, text
        assert 0.0 <= box.y0 < box.y1 <= height, text
    for (first, one), (second, other) in itertools.combinations(placed, 2):
        over = Bbox.intersection(one, other)
        assert over is None or min(over.width, over.height) < 0.1, (first, second)
    assert min(text.get_fontsize() for text in texts_of(figure)) >= 6.5


def test_six_teachers_fit_on_a_page() -> None:
    figure = compose_paper_figure(CASES["six teachers"]())
    assert figure.get_size_inches()[1] * 25.4 < 200.0


@pytest.mark.parametrize("name", ["three teachers", "one fit", "one size", "many sizes"])
def test_every_learner_has_marks_of_its_colour_in_every_panel(name: str) -> None:
    results = CASES[name]()
    figure = compose_paper_figure(results)
    pixels = pixels_of(figure)
    assert len(figure.axes) == len(results.teachers)
    for axes, learner in itertools.product(figure.axes, results.learners):
        box = axes.bbox
        panel = pixels[len(pixels) - int(box.y1) : len(pixels) - int(box.y0)]
        panel = panel[:, int(box.x0) : int(box.x1)]
        assert (panel == learner_colour(learner)).all(axis=-1).sum() > 30


def test_learners_differ_without_their_colours() -> None:
    figure = compose_paper_figure(CASES["five learners"]())
    samples = [artist for artist in figure.artists if isinstance(artist, Line2D)]
    assert len(samples) == 3 * len(EVERYBODY)
    assert len({line.get_marker() for line in samples}) == len(EVERYBODY)


def test_panels_and_lines_are_named() -> None:
    texts = said(compose_paper_figure(case()))
    for title in ("(a) EU teacher", "(b) T&K teacher", "(c) Strong teacher"):
        assert texts.count(title) == 1
    assert texts.count("CPT") == texts.count("EU") == 3
    assert "α 0.88  η 0.88  λ 2.25  γ 0.61  δ 0.69" in texts
    assert texts.count("2000") == 1
    assert "Strong teacher" in said(compose_paper_figure(case((TEACHERS["strong"],))))


def test_no_regret_has_a_place_on_the_axis_where_there_is_some() -> None:
    assert "0" not in said(compose_paper_figure(case()))
    assert "0" in said(compose_paper_figure(case(regret_percent=0.0)))


def test_the_caption_says_what_a_reader_needs_to_know() -> None:
    caption = paper_caption(case())
    assert "\n" not in caption
    for part in (
        "25 to 2000 preference pairs",
        "(a) EU teacher, (b) T&K teacher and (c) Strong teacher",
        "mean over 3 seeds",
        "95 % bootstrap interval",
        "82 % certain",
    ):
        assert part in caption
    assert "converge" not in caption
    assert "126 of 126 fits did not converge" in paper_caption(case(converged=False))
    assert "interval" not in paper_caption(case(seeds=1))
    assert "1 to 3 seeds" in paper_caption(without_the_end(8))
    assert "no fits" in paper_caption(without_the_end(126))


def pdf_text(text: str) -> bytes:
    return text.encode().replace(b"(", rb"\(").replace(b")", rb"\)")


@pytest.mark.parametrize("name", ["three teachers", "odd names"])
def test_a_pdf_is_one_column_wide_and_brings_its_fonts(name: str, tmp_path: Path) -> None:
    path = tmp_path / "curves.pdf"
    write_paper_figure(path, CASES[name]())
    data = path.read_bytes()
    assert data.startswith(b"%PDF")
    [box] = re.findall(rb"/MediaBox \[ 0 0 (\S+) \S+ \]", data)
    assert float(box) == pytest.approx(COLUMN, abs=0.01)
    fonts = data.count(b"/Type /FontDescriptor")
    assert fonts == data.count(b"/FontFile2") >= 2
    assert b"/Type3" not in data
    assert b"Date" not in data


def test_a_pdf_holds_its_caption(tmp_path: Path) -> None:
    path = tmp_path / "curves.PDF"
    write_paper_figure(path, case())
    assert pdf_text(paper_caption(case())) in path.read_bytes()


@pytest.mark.parametrize("name", ["three teachers", "odd names"])
def test_an_svg_is_one_column_wide_and_holds_its_caption(name: str, tmp_path: Path) -> None:
    path = tmp_path / "curves.svg"
    results = CASES[name]()
    write_paper_figure(path, results)
    root = ElementTree.parse(path).getroot()
    assert root.attrib["width"].endswith("pt")
    assert float(root.attrib["width"][:-2]) == pytest.approx(COLUMN, abs=0.01)
    assert paper_caption(results) in [element.text for element in root.iter()]
    tags = {element.tag.rpartition("}")[2] for element in root.iter()}
    assert "text" not in tags  # letters are outlines
    assert "date" not in tags


@pytest.mark.parametrize("suffix", [".pdf", ".svg"])
def test_the_same_table_gives_the_same_bytes(suffix: str, tmp_path: Path) -> None:
    results = case()
    pq.write_table(results.table, tmp_path / "table.parquet")
    here, there = tmp_path / f"here{suffix}", tmp_path / f"there{suffix}"
    with mpl.rc_context({"font.size": 20.0, "lines.linewidth": 9.0, "pdf.fonttype": 3}):
        mine = dict(mpl.rcParams)
        write_paper_figure(here, results)
        assert dict(mpl.rcParams) == mine
    script = (
        "import sys; from pathlib import Path; import pyarrow.parquet as pq\n"
        "from learners import TEACHERS\n"
        "from studio.study.paper.figure import write_paper_figure\n"
        "from studio.study.results import StudyResults\n"
        "results = StudyResults(pq.read_table(sys.argv[1]), tuple(TEACHERS.values()))\n"
        "write_paper_figure(Path(sys.argv[2]), results)\n"
        "assert 'matplotlib.pyplot' not in sys.modules\n"
    )
    subprocess.run([sys.executable, "-c", script, tmp_path / "table.parquet", there], check=True)
    assert here.read_bytes() == there.read_bytes()


@pytest.fixture(scope="module")
def bank(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("bank") / "bank.parquet"
    write_bank(path, BankPlan(scenes=8, rollouts=4))
    return path


def learn(bank: Path, *arguments: str | Path) -> Result:
    return run("learn", "--outcomes", bank, "--pairs", "10,30", "--seeds", "2", *arguments)


@pytest.mark.parametrize("name", ["curves.pdf", "curves.svg"])
def test_learn_writes_the_figure_where_it_is_wanted(name: str, bank: Path, tmp_path: Path) -> None:
    figure = tmp_path / "paper" / "figures" / name
    result = learn(bank, "--out", tmp_path / "out", "--figure", figure)
    assert result.exit_code == 0, result.stderr
    assert figure.stat().st_size > 5000
    assert [path.name for path in figure.parent.iterdir()] == [name]
    assert str(figure) in result.stdout
    [caption] = [line for line in result.stdout.splitlines() if line.startswith("caption: ")]
    assert "mean over 2 seeds" in caption
    # the recordings of single scenes have a folder of their own
    written = [path for path in (tmp_path / "out").iterdir() if path.is_file()]
    assert len(written) == 4


def test_without_a_figure_no_caption_is_told(bank: Path, tmp_path: Path) -> None:
    result = learn(bank, "--teachers", "eu", "--learners", "eu", "--out", tmp_path)
    assert result.exit_code == 0, result.stderr
    assert "caption" not in result.stdout


def check_refused(result: Result, says: str, folder: Path) -> None:
    assert result.exit_code == 2, result.exception
    assert result.stderr.count("\n") == 1
    assert says in result.stderr
    assert not (folder / "out").exists()


@pytest.mark.parametrize("name", ["curves.png", "curves", "curves.pdf.gz", ".pdf"])
def test_other_kinds_of_files_are_refused(name: str, bank: Path, tmp_path: Path) -> None:
    result = learn(bank, "--out", tmp_path / "out", "--figure", tmp_path / name)
    check_refused(result, "is not allowed: a name that ends in .pdf or .svg", tmp_path)
    assert not list(tmp_path.iterdir())


def test_a_figure_that_cannot_be_written_is_refused(bank: Path, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    (tmp_path / "folder.pdf").mkdir()
    for name in ("file/curves.pdf", "folder.pdf"):
        result = learn(bank, "--out", tmp_path / "out", "--figure", tmp_path / name)
        check_refused(result, name, tmp_path)


def test_without_matplotlib_it_says_how_to_install_it(
    bank: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    result = learn(bank, "--out", tmp_path / "out", "--figure", tmp_path / "curves.pdf")
    check_refused(result, "pip install 'prospect-studio[figures]'", tmp_path)
    options = ("--teachers", "eu", "--learners", "eu", "--out", tmp_path)
    assert learn(bank, *options).exit_code == 0  # the rest does not need it
