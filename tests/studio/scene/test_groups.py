from itertools import combinations

import numpy as np

from studio.scene.groups import shortest_links


def spans(links: list[tuple[int, int]], size: int) -> bool:
    reached = {0}
    for _ in links:
        reached |= {end for link in links if reached & set(link) for end in link}
    return len(reached) == size


def test_links_join_everybody_with_the_least_length() -> None:
    moments = np.random.default_rng(0).uniform(0.0, 5.0, (6, 5, 2))
    found = shortest_links(moments)
    assert found.shape == (6, 4, 2)
    for places, links in zip(moments, found.tolist(), strict=True):
        length = {
            pair: float(np.hypot(*(places[pair[0]] - places[pair[1]])))
            for pair in combinations(range(5), 2)
        }
        least = min(
            sum(length[pair] for pair in tree)
            for tree in combinations(length, 4)
            if spans(list(tree), 5)
        )
        assert spans([tuple(link) for link in links], 5)
        assert np.isclose(sum(length[min(link), max(link)] for link in links), least)


def test_one_moment_of_one_pair() -> None:
    assert shortest_links(np.array([[0.0, 0.0], [1.0, 0.0]])).tolist() == [[0, 1]]
