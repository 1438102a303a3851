from rerun import escape_entity_path_part as entity_part

from studio.recorder.markdown import link, plain, table


def test_a_table_has_a_rule_under_its_heads():
    assert table(["a", "b"], "lr", [["x", "1"], ["y", "2"]]) == [
        "| a | b |",
        "|:--|--:|",
        "| x | 1 |",
        "| y | 2 |",
    ]


def test_a_link_leads_to_an_entity_whatever_its_name():
    path = f"figures/{entity_part('my aunt')}"
    assert path == "figures/my\\ aunt"
    assert link(plain("my_aunt"), path) == r"[my\_aunt](<recording://figures/my\\ aunt>)"
