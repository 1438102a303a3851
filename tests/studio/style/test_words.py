from studio.style.words import action_label, counted, number, rounded_number, signed


def test_numbers_are_short_and_have_a_true_minus_sign():
    assert [number(value) for value in (0.0, 0.5, -2.0)] == ["0", "0.5", "−2"]


def test_numbers_show_neither_rounding_errors_nor_a_signed_zero():
    assert rounded_number(0.1 + 0.2, 6) == "0.3"
    assert rounded_number(-0.0004, 3, ".3f") == "0.000"
    assert [signed(value) for value in (0.1, -0.25, -0.001)] == ["+0.10", "−0.25", "0.00"]


def test_labels_of_actions_and_counts_are_words():
    assert action_label("slow_down") == "slow down"
    assert [counted(count, "pair") for count in (0, 1, 2)] == ["0 pairs", "1 pair", "2 pairs"]
