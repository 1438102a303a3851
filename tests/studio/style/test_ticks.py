import pytest
from hypothesis import given
from hypothesis import strategies as st

from studio.style.ticks import decades, round_numbers, round_range, round_step, ticks


@given(span=st.floats(1e-6, 1e6), most=st.integers(1, 50))
def test_a_round_step_suffices_and_no_smaller_one_does(span, most):
    step = round_step(span, most)
    digit, _, zeros = f"{step:e}".partition("e")
    smaller = float(f"{ {1: 0.5, 2: 1, 5: 2}[float(digit)] }e{zeros}")
    assert most * smaller < span <= most * step


def test_round_steps_may_have_other_digits():
    assert [round_step(span, 1) for span in (1.0, 1.1, 2.4, 5.1)] == [1.0, 2.0, 5.0, 10.0]
    assert round_step(0.24, 1, (1, 2, 2.5, 5)) == 0.25


def test_round_numbers_are_exact_decimals_in_order():
    assert round_numbers(0.1, 5.0) == [0.1, 0.2, 0.5, 1.0, 2.0, 5.0]
    assert round_numbers(0.2, 9.0, (1, 3)) == [0.3, 1.0, 3.0]


@given(low=st.floats(-1e4, 1e4), length=st.floats(1e-3, 1e4))
def test_axes_end_at_round_values_around_the_data(low, length):
    start, end = round_range(low, low + length)
    assert start <= low + 1e-6 * length
    assert end >= low + length * (1 - 1e-6)
    assert end - start <= 1.5 * length
    marks = ticks(start, end, 4)
    assert 1 <= len(marks) <= 6
    assert all(start - 1e-6 * length <= mark <= end + 1e-6 * length for mark in marks)


@pytest.mark.parametrize(
    ("low", "high", "found"),
    [(0.02, 90.0, [0.1, 1.0, 10.0]), (0.2, 9.0, [0.3, 1.0, 3.0]), (1.0, 5.0, [1.0, 2.0, 5.0])],
)
def test_decades_get_finer_where_there_are_few(low, high, found):
    assert decades(low, high) == found
