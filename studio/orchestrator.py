"""The one orchestrator: from a scene to rollouts, outcomes, and files that a person looks at.

Everything heavy is imported where it is used: to import the studio costs nothing, and who wants no
picture does not wait for what draws it.
"""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from studio.files import check_is_recording, file_name, replacing
from studio.progress import Quiet
from studio.scene.sources import Source, find_scene
from studio.study.paper.check import check_figure

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    import pyarrow as pa

    from learners import Learner, Study, Teacher
    from scenes import Rollouts, Scene
    from scenes.bank import BankPlan
    from scenes.rollouts import Engine
    from studio.comparison.comparison import Comparison
    from studio.recording import Excerpt, Look, Recording
    from studio.scene.judgements import Judgement
    from studio.study.links import Links
    from studio.study.results import StudyResults


@dataclass(frozen=True, kw_only=True)
class Made:
    """What was made: the files, the recording first, or of a study the table first."""

    files: tuple[Path, ...]


@dataclass(frozen=True, kw_only=True)
class Recorded(Made):
    """What came of recording a scene: its rollouts, and what each teacher thinks of its actions."""

    rollouts: Rollouts
    judgements: tuple[Judgement, ...]


@dataclass(frozen=True, kw_only=True)
class Compared(Made):
    """What came of comparing two actions, which are on random sides.

    The judgements are what each teacher thinks of the two, left then right.
    """

    comparison: Comparison
    judgements: tuple[Judgement, ...]


@dataclass(frozen=True, kw_only=True)
class Learned(Made):
    """What came of a study; recordings of single scenes come last among its files.

    The caption is one for the figure, in one line; it is empty without a figure.
    """

    results: StudyResults
    caption: str = ""

    @property
    def table(self) -> pa.Table:
        """One row a fit, see `learners.STUDY_SCHEMA`."""
        return self.results.table


class Studio:
    """Does from Python what the command line does.

    Example:
        `Studio(out="recordings").record("doorway", seed=0)`
    """

    def __init__(self, out: str | Path = "recordings", progress: Quiet | None = None) -> None:
        """Take the folder for output, and who is told how far the work is: nobody if left out."""
        self.out = Path(out)
        self.progress = progress or Quiet()

    def record(
        self,
        scene: str | Path | Source | Scene,
        seed: int = 0,
        *,
        png: bool = True,
        mp4: bool = True,
        **settings: Any,
    ) -> Recorded:
        """Simulate a scene and write its recording, picture and film.

        Args:
            scene: a scene, where it comes from, or just the name or path of where.
            seed: of the noise, and of the scene if only its family is named.
            png: whether to write the picture.
            mp4: whether to write the film.
            settings: further arguments of `scenes.simulate`: rollouts, horizon, model, engine,
                noise and so on.

        Raises:
            InputError: if there is no such scene, a setting is not allowed (`scenes.InputError`),
                or the folder cannot be written to.
        """
        found = self._find(scene, seed)
        with self._recording(found.name, png, mp4) as (part, files):
            rollouts = self._simulate(found, seed, settings)

            from studio.scene.judgements import judge
            from studio.scene.recording.write import write_recording
            from studio.scene.reference import reference_utilities

            judgements = judge(rollouts, reference=reference_utilities(rollouts))
            write_recording(part, rollouts, judgements)
        return Recorded(files=files, rollouts=rollouts, judgements=judgements)

    def compare(
        self,
        scene: str | Path | Source | Scene,
        one: str,
        other: str,
        seed: int = 0,
        *,
        png: bool = True,
        mp4: bool = True,
        **settings: Any,
    ) -> Compared:
        """Put two actions of a scene side by side; write recording, picture and film.

        The further arguments are those of `record`; the seed is also that of which action comes to
        the left.

        Raises:
            InputError: if there is no such scene or action, a setting is not allowed
                (`scenes.InputError`), or the folder cannot be written to.
        """
        from scenes import META_ACTIONS
        from studio.comparison.comparison import check_two, side_by_side

        check_two(one, other, [each.name for each in settings.get("actions", META_ACTIONS)])
        found = self._find(scene, seed)
        with self._recording(file_name(found.name, one, other), png, mp4) as (part, files):
            comparison = side_by_side(self._simulate(found, seed, settings), one, other, seed)

            from studio.comparison.recording.write import write_comparison_recording
            from studio.scene.judgements import judge
            from studio.scene.reference import reference_utilities

            reference = reference_utilities(comparison.rollouts)
            judgements = judge(comparison.rollouts, reference=reference)
            write_comparison_recording(part, comparison, judgements)
        return Compared(files=files, comparison=comparison, judgements=judgements)

    def render(
        self,
        recording: str | Path,
        *files: str | Path,
        look: Look | None = None,
        excerpt: Excerpt | None = None,
    ) -> tuple[Path, ...]:
        """Paint pictures and films from a recording alone; nothing is simulated again.

        The recording may be of an older version of the studio. The endings of the files say what
        they become: `.png`, `.mp4` or `.gif`; without any, a picture and a film are written beside
        the recording. What was written is given back.

        Raises:
            InputError: if the file is not a recording of the studio, an ending, the look or the
                excerpt is not allowed, or a file cannot be written.
        """
        from studio.kinds import read_recording
        from studio.recording import Excerpt, Look, check_files

        source = Path(recording)
        wanted = tuple(map(Path, files)) or (source.with_suffix(".png"), source.with_suffix(".mp4"))
        look, excerpt = look or Look(), excerpt or Excerpt()
        read = read_recording(source)
        check_files(wanted, read, excerpt)
        with replacing(*wanted, option="--png, --mp4, --gif") as parts:
            self._paint(parts, read, look, excerpt)
        return wanted

    def sample(self, path: str | Path, plan: BankPlan) -> Path:
        """Sample the outcome bank of a plan into a Parquet file.

        Raises:
            InputError: if the plan asks for something that cannot be simulated
                (`scenes.InputError`), or the file cannot be written.
        """
        from scenes.bank import write_bank

        path = Path(path)
        with replacing(path) as [part]:
            self._warm_up(plan.engine)
            with self.progress.steps("scenes") as done:
                write_bank(part, plan, done)
        return path

    def learn(
        self,
        outcomes: str | Path | None = None,
        teachers: Sequence[Teacher | str] = ("eu", "tk", "strong"),
        learners: Sequence[Learner | str] = ("eu", "cpt"),
        pairs: Sequence[int] = (25, 50, 100, 200, 500, 1000, 2000),
        seeds: int = 5,
        figure: str | Path | None = None,
    ) -> Learned:
        """Study how well learners recover what teachers want; write table, picture and recording.

        The few scenes in which the learners differ most are recorded too, in the folder `scenes`
        beside, and linked to, if the bank says how to make them again.

        A study that was interrupted continues where it stopped: what is finished is kept beside
        the output until the whole is there.

        Args:
            outcomes: the outcome bank to study; left out, the default bank is sampled to
                `outcomes.parquet` in the folder for output, or taken from there.
            teachers: who prefers, or names of `learners.TEACHERS`.
            learners: who learns, or names of `learners.LEARNERS`.
            pairs: numbers of pairs to learn from.
            seeds: how many repetitions.
            figure: the figure for a paper to write as well, a PDF or SVG file; left out, none.

        Raises:
            InputError: if the folder cannot be written to, the figure cannot be drawn, or something
                cannot be studied (`learners.InputError`, `scenes.InputError`).
        """
        drawn = () if figure is None else (check_figure(Path(figure)),)
        from learners import Study, find_learners, find_teachers, read_bank

        who, fitted = find_teachers(teachers), find_learners(learners)
        bank = Path(outcomes) if outcomes is not None else self._default_bank()
        study = Study(read_bank(bank), who, fitted, tuple(pairs), seeds)
        unfinished = self.out / ".learning.unfinished.parquet"
        files = tuple(self.out / f"learning{suffix}" for suffix in (".parquet", ".png", ".rrd"))
        with replacing(*files) as parts, replacing(*drawn, option="--figure") as papers:
            from studio.study.run import run_or_resume
            from studio.study.write import write_study

            with self.progress.steps("fits") as done:
                results = run_or_resume(study, unfinished, done)
            # the scenes come first, so that no link ever leads nowhere
            links = self._record_scenes(study, results.told_scenes, bank)
            caption = write_study(parts, papers, results, bank.name, links)
        unfinished.unlink(missing_ok=True)
        scenes = [self.out / link.path for link in links.values()]
        return Learned(files=(*files, *drawn, *scenes), results=results, caption=caption)

    def _record_scenes(self, study: Study, numbers: Sequence[int], bank: Path) -> Links:
        """Record these scenes of the bank, as far as they can be made again."""
        from scenes.bank import read_plan
        from studio.study.scenes import record_scenes

        plan = read_plan(bank)
        if plan is None or not numbers:
            return {}
        self._warm_up(plan.engine)
        with self.progress.steps("recordings of scenes") as done:
            return record_scenes(self.out, plan, study.prospects, numbers, done)

    def _default_bank(self) -> Path:
        """The default bank in the folder for output, sampled unless it is there already."""
        from scenes.bank import BankPlan, is_bank_of

        path, plan = self.out / "outcomes.parquet", BankPlan()
        return path if is_bank_of(plan, path) else self.sample(path, plan)

    def view(self, path: str | Path) -> None:
        """Open a recording in the Rerun viewer, and wait until it is closed.

        The viewer starts in the recording's folder, which is where links to others start from.

        Raises:
            InputError: if the file is not a recording.
            RunError: if the viewer fails.
        """
        path = Path(path)
        check_is_recording(path)
        from studio.recorder.viewer import open_viewer

        open_viewer(path)

    def _find(self, scene: str | Path | Source | Scene, seed: int) -> Scene:
        if isinstance(scene, str | Path):
            scene = Source(str(scene), seed=seed)
        return find_scene(scene) if isinstance(scene, Source) else scene

    @contextmanager
    def _recording(
        self, name: str, png: bool, mp4: bool
    ) -> Iterator[tuple[Path, tuple[Path, ...]]]:
        """Where the block writes a recording, and all files that are there once it has succeeded.

        The pictures are painted from what was just recorded, not from what was simulated: the
        picture is the data.
        """
        suffixes = [".rrd", *([".png"] if png else []), *([".mp4"] if mp4 else [])]
        files = tuple(self.out / f"{name}{suffix}" for suffix in suffixes)
        with replacing(*files) as [part, *pictures]:
            yield part, files
            if pictures:
                from studio.kinds import read_recording

                self._paint(pictures, read_recording(part))

    def _simulate(self, scene: Scene, seed: int, settings: dict[str, Any]) -> Rollouts:
        from scenes import simulate

        self._warm_up(settings.get("engine", "batched"))
        return simulate(scene, seed=seed, **settings)

    def _warm_up(self, engine: Engine) -> None:
        """Get an engine ready, and say why that takes long if it has to be compiled first."""
        from scenes import warm_up

        note = "Preparing the engine; the first use compiles it, about a quarter of a minute ..."
        with self.progress.waiting(note):
            warm_up(engine)

    def _paint(
        self,
        parts: Sequence[Path],
        recording: Recording,
        look: Look | None = None,
        excerpt: Excerpt | None = None,
    ) -> None:
        """Paint a recording into files, and tell how far a film is."""
        from studio.recording import write_picture

        for part in parts:
            if part.suffix == ".png":
                write_picture(part, recording, look, excerpt)
            else:
                with self.progress.steps("film") as done:
                    write_picture(part, recording, look, excerpt, done)
