"""Scenes of every family and pattern, drawn at random."""

from hypothesis import settings
from hypothesis import strategies as st

from scenes.families import FAMILIES, load_scene

COMBINATIONS = [(name, p) for name, family in FAMILIES.items() for p in family.patterns]


any_scene = st.builds(
    lambda combination, seed, number: load_scene(*combination, seed, number),
    st.sampled_from(COMBINATIONS),
    st.integers(0, 2**63 - 1),
    st.integers(0, 2**31 - 1),
)


series = settings(deadline=None, derandomize=True, max_examples=150)
