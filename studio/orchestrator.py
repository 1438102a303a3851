"""The one orchestrator: from a scene to rollouts, outcomes, and files that a person looks at.

Everything heavy is imported where it is used: to import the studio costs nothing, and who wants no
picture does not wait for what draws it.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from studio.errors import InputError
from studio.files import check_is_recording, checked_name, file_name, replacing
from studio.made.files import files_of, paint, recording_into
from studio.made.results import Compared, Learned, Recorded
from studio.progress import Quiet
from studio.scene.sources import Source, find_scene, words_of
from studio.study.paper.check import check_figure

if TYPE_CHECKING:
    from collections.abc import Sequence

    from learners import Learner, Study, Teacher
    from scenes import Rollouts, Scene
    from scenes.bank import BankPlan
    from scenes.rollouts import Engine
    from studio.recording import Excerpt, Look
    from studio.study.links import Links


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
        name: str | None = None,
        force: bool = False,
        **settings: Any,
    ) -> Recorded:
        """Simulate a scene and write its recording, picture and film.

        Args:
            scene: a scene, where it comes from, or just the name or path of where.
            seed: of the noise, and of the scene if only its family is named.
            png: whether to write the picture.
            mp4: whether to write the film.
            name: of the files, without an ending; left out, the scene's, with whatever is unusual
                of pattern, number and seed, for example `intersection-11`.
            force: whether the files may replace those of something else. Those of the very same
                recording are always replaced.
            settings: further arguments of `scenes.simulate`: rollouts, horizon, model, engine,
                noise and so on.

        Raises:
            InputError: if there is no such scene, a setting is not allowed (`scenes.InputError`),
                the folder cannot be written to, or something else has the files' names.
        """
        found = self._find(scene, seed)
        name = file_name(*words_of(found, seed)) if name is None else checked_name(name)
        files = files_of(self.out / name, png, mp4)
        with recording_into(files, force, self.progress) as part:
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
        names: bool = False,
        png: bool = True,
        mp4: bool = True,
        name: str | None = None,
        force: bool = False,
        **settings: Any,
    ) -> Compared:
        """Put two actions of a scene side by side; write recording, picture and film.

        They are for a person who is to choose, and therefore tell neither which action is on which
        side, nor what the teachers think of it, unless `names` says so. The further arguments are
        those of `record`; the seed is also that of which action comes to the left.

        Raises:
            InputError: if there is no such scene or action, a setting is not allowed
                (`scenes.InputError`), the folder cannot be written to, or something else has the
                files' names.
        """
        from scenes import META_ACTIONS
        from studio.comparison.comparison import check_two, side_by_side, words_of_pair

        check_two(one, other, [each.name for each in settings.get("actions", META_ACTIONS)])
        found = self._find(scene, seed)
        usual = file_name(*words_of(found, seed), *words_of_pair(one, other, names))
        name = usual if name is None else checked_name(name)
        files = files_of(self.out / name, png, mp4)
        with recording_into(files, force, self.progress) as part:
            rollouts = self._simulate(found, seed, settings)
            comparison = side_by_side(rollouts, one, other, seed, named=names)

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
            paint(parts, read, self.progress, look, excerpt)
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
        *,
        name: str = "learning",
        force: bool = False,
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
            name: of the files, without an ending; under any but the usual name, the folder for
                recordings of scenes has it, too.
            force: whether the files may replace those of something else. Those of the same study
                are always replaced, if it has as many fits or more.

        Raises:
            InputError: if the folder cannot be written to, something else has the files' names, the
                figure cannot be drawn, or something cannot be studied (`learners.InputError`,
                `scenes.InputError`).
        """
        drawn = () if figure is None else (check_figure(Path(figure)),)
        from learners import Study, find_learners, find_teachers, read_bank

        who, fitted = find_teachers(teachers), find_learners(learners)
        from studio.study.run import check_loses_no_fits

        name = checked_name(name)
        bank = Path(outcomes) if outcomes is not None else self._default_bank()
        study = Study(read_bank(bank), who, fitted, tuple(pairs), seeds)
        unfinished = self.out / f".{name}.unfinished.parquet"
        files = tuple(
            self.out / f"{name}{suffix}" for suffix in (".parquet", ".png", ".rrd", "-2.png")
        )
        if not force:
            check_loses_no_fits(study, files, unfinished)
        with replacing(*files) as parts, replacing(*drawn, option="--figure") as papers:
            from studio.study.run import run_or_resume
            from studio.study.write import write_study

            with self.progress.steps("fits") as done:
                results = run_or_resume(study, unfinished, done)
            # the scenes come first, so that no link ever leads nowhere
            folder = self.out / ("scenes" if name == "learning" else f"{name}-scenes")
            links = self._record_scenes(study, results.told_scenes, bank, folder, force)
            caption = write_study(parts, papers, results, bank.name, links)
        unfinished.unlink(missing_ok=True)
        scenes = [self.out / link.path for link in links.values()]
        return Learned(files=(*files, *drawn, *scenes), results=results, caption=caption)

    def _record_scenes(
        self, study: Study, numbers: Sequence[int], bank: Path, folder: Path, force: bool
    ) -> Links:
        """Record these scenes of the bank into a folder, as far as they can be made again."""
        from scenes.bank import read_plan
        from studio.study.scenes import record_scenes

        plan = read_plan(bank)
        if plan is None or not numbers:
            return {}
        self._warm_up(plan.engine)
        with self.progress.steps("recordings of scenes") as done:
            return record_scenes(folder, plan, study.prospects, numbers, done, force=force)

    def _default_bank(self) -> Path:
        """The default bank in the folder for output, sampled unless it is there already."""
        from scenes.bank import BankPlan, is_bank_of, read_plan

        path, plan = self.out / "outcomes.parquet", BankPlan()
        if is_bank_of(plan, path):
            return path
        if path.exists() and read_plan(path) != plan:
            raise InputError(
                f"{path}: is not the default bank: name it with --outcomes, or move it"
            )
        return self.sample(path, plan)

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
