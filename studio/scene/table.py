"""The outcomes of a scene as a table, for whoever goes on with them elsewhere."""

import pyarrow as pa

from scenes import Rollouts
from scenes.bank import outcome_rows
from studio.scene.judgements import utilities


def outcomes_as_table(rollouts: Rollouts) -> pa.Table:
    """One row an outcome, action by action: the columns of an outcome bank, and the utility θ*·φ.

    The columns are `scenes.bank.BANK_SCHEMA` (scene, family, pattern, action, rollout, the scaled
    features, clearance, deviation and progress in m, how many people and whether a wall was
    touched) and `utility`.
    """
    return outcome_rows(rollouts).append_column("utility", pa.array(utilities(rollouts).ravel()))
