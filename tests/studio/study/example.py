"""A recording of a study, for the tests that look at every kind of recording."""

from pathlib import Path

from scenes.bank import BankPlan, write_bank
from studio.orchestrator import Studio


def make(folder: Path) -> Path:
    bank = folder / "bank.parquet"
    write_bank(bank, BankPlan(scenes=16, rollouts=8))
    return Studio(folder).learn(bank, ("eu", "tk"), pairs=(10, 30), seeds=2).files[2]
