"""How long the study takes, and how much faster its fits are than plain autograd.

The peer is what one would write first: one fit after another, `torch.optim.LBFGS` with a strong
Wolfe line search on the Bradley–Terry loss, values from `learners.prospect_value` of both prospects
of every pair. It has the same prior, starts from θ = 0 and the first of our starts, and stops when
the gradient or the progress vanishes or after 200 evaluations. It runs a few fits of each size;
from their times that of all fits of the study is extrapolated. Both may use every processor.

    python -m benchmarks.learning [OUTCOMES.parquet]

Without a bank, one of 300 scenes is sampled first.
"""

import os
import resource
import sys
import tempfile
import time
from dataclasses import fields
from pathlib import Path
from statistics import median
from types import SimpleNamespace

import numpy as np
import torch

from learners import (
    BETA,
    LEARNERS,
    TEACHERS,
    CptParameters,
    Preferences,
    Problem,
    Prospects,
    Teacher,
    ask,
    fit_many,
    prospect_value,
    read_bank,
    run_study,
    sample_pairs,
    split_scenes,
)
from learners.fitting.cpt import PARAMETER_DEVIATION, STARTS
from learners.fitting.fits import REWARD_DEVIATION
from learners.studying.plan import SIZES
from scenes.bank import BankPlan, write_bank

SEEDS = 5
PEER_SEEDS = 1
PARAMETERS = [field.name for field in fields(CptParameters)]


def peer_fit(prospects: Prospects, told: Preferences, learner: str) -> float:
    """Fit one learner by autograd; the objective reached, nats."""
    features = torch.from_numpy(np.array(prospects.features))
    preferred = features[told.scenes, told.preferred]  # (N, K, D)
    other = features[told.scenes, told.other]
    count = 5 if learner == "cpt" else 0
    deviation = torch.tensor(
        [*[REWARD_DEVIATION] * features.shape[-1], *PARAMETER_DEVIATION[:count]],
        dtype=torch.float64,
    )
    start = np.concatenate([np.zeros(features.shape[-1]), np.log(STARTS[0].numbers)[:count]])
    z = torch.tensor(start, requires_grad=True)

    def worth(features: torch.Tensor) -> torch.Tensor:
        utilities = features @ z[: features.shape[-1]]
        if not count:
            return utilities.mean(-1)
        mind = SimpleNamespace(**dict(zip(PARAMETERS, z[-count:].exp(), strict=True)))
        return prospect_value(utilities, mind)

    def loss() -> torch.Tensor:
        margin = BETA * (worth(preferred) - worth(other))
        return torch.nn.functional.softplus(-margin).sum() + 0.5 * ((z / deviation) ** 2).sum()

    def closure() -> torch.Tensor:
        optimiser.zero_grad()
        objective = loss()
        objective.backward()
        return objective

    optimiser = torch.optim.LBFGS(
        [z], max_iter=200, max_eval=200, tolerance_change=1e-9, line_search_fn="strong_wolfe"
    )
    optimiser.step(closure)
    return float(loss().detach())


def our_objective(prospects: Prospects, told: Preferences, learner: str) -> float:
    """The objective that the learner of the studio reaches, nats."""
    fit = LEARNERS[learner].fit(prospects, told)
    logs = np.log(fit.parameters.numbers) if fit.parameters else np.zeros(5)
    prior = ((fit.theta / REWARD_DEVIATION) ** 2).sum() + ((logs / PARAMETER_DEVIATION) ** 2).sum()
    return fit.nll * len(told) + 0.5 * float(prior)


def questions(
    prospects: Prospects, teacher: Teacher, size: int, seed: int
) -> tuple[Prospects, Preferences]:
    """What is learned from in the study."""
    pairs = sample_pairs(prospects, size, seed, split_scenes(prospects, seed).training)
    return prospects, ask(teacher, prospects, pairs, seed)


def our_fits(prospects: Prospects) -> float:
    """Seconds that all fits take as one batch, median of three."""
    problems = [
        Problem(LEARNERS[learner], *questions(prospects, teacher, size, seed))
        for size in SIZES
        for learner in ("eu", "cpt")
        for teacher in TEACHERS.values()
        for seed in range(SEEDS)
    ]
    taken = []
    for _ in range(3):
        start = time.perf_counter()
        fit_many(problems)
        taken.append(time.perf_counter() - start)
    return median(taken)


def peer_fits(prospects: Prospects) -> float:
    """Seconds that the peer would take for all fits."""
    peer_fit(*questions(prospects, TEACHERS["eu"], SIZES[0], 0), "cpt")  # torch warms up
    total = 0.0
    for size in SIZES:
        for learner in ("eu", "cpt"):
            taken, behind = [], []
            for teacher in TEACHERS.values():
                for seed in range(PEER_SEEDS):
                    training, told = questions(prospects, teacher, size, seed)
                    start = time.perf_counter()
                    reached = peer_fit(training, told, learner)
                    taken.append(time.perf_counter() - start)
                    behind.append(reached - our_objective(training, told, learner))
            total += float(np.mean(taken)) * len(TEACHERS) * SEEDS
            print(
                f"  peer, {learner:3} from {size:4} pairs: {np.mean(taken):6.2f} s a fit, ends "
                f"{np.min(behind):+.3f} to {np.max(behind):+.3f} nats from where ours does"
            )
    return total


def main() -> None:
    """Measure the study and the peer, and print both beside what is wanted."""
    with tempfile.TemporaryDirectory() as folder:
        if len(sys.argv) > 1:
            path = Path(sys.argv[1])
        else:
            path = Path(folder) / "outcomes.parquet"
            write_bank(path, BankPlan())
        prospects = read_bank(path)
    print(f"{len(prospects.scenes)} scenes; {os.cpu_count()} processors")

    for workers in (1, None, 1, None):
        start = time.perf_counter()
        table = run_study(prospects, seeds=SEEDS, workers=workers)
        taken = time.perf_counter() - start
        print(
            f"study, {table.num_rows} fits, {workers or os.cpu_count()} at a time: "
            f"{taken:.1f} s (wanted: 60 s); {sum(table['converged'].to_pylist())} converged"
        )
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    print(f"peak memory: {peak:.2f} GB (wanted: 1.5 GB)")

    fitted = our_fits(prospects)
    theirs = peer_fits(prospects)
    print(
        f"all fits and nothing else: {fitted:.1f} s, peer {theirs:.0f} s (extrapolated): "
        f"{theirs / fitted:.0f} times faster (wanted: 20)"
    )


if __name__ == "__main__":
    main()
