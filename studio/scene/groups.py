"""Who of a group walks beside whom."""

import numpy as np

from studio.arrays import FloatArray, IntArray


def shortest_links(places: FloatArray) -> IntArray:
    """Pairs of people that join a whole group with the least length.

    Prim's algorithm ("Shortest Connection Networks and Some Generalizations", Bell System
    Technical Journal 36, 1957), for many moments at once.

    Args:
        places: [..., N, 2], where the N people of the group are, m.

    Returns:
        [..., N − 1, 2], indices of the two people whom each link joins.
    """
    *moments, size, _ = places.shape
    flat = places.reshape(-1, size, 2)
    distance = np.linalg.norm(flat[:, :, None] - flat[:, None], axis=-1)  # (M, N, N)
    every = np.arange(len(flat))
    links = np.empty((len(flat), size - 1, 2), dtype=np.int64)
    nearest, gap = np.zeros((len(flat), size), dtype=np.int64), distance[:, 0]  # of those joined
    is_joined = np.zeros((len(flat), size), dtype=bool)
    is_joined[:, 0] = True
    for link in range(size - 1):
        new = np.where(is_joined, np.inf, gap).argmin(axis=1)
        links[:, link] = np.stack([nearest[every, new], new], axis=-1)
        is_joined[every, new] = True
        is_nearer = distance[every, new] < gap
        nearest = np.where(is_nearer, new[:, None], nearest)
        gap = np.where(is_nearer, distance[every, new], gap)
    return links.reshape(*moments, size - 1, 2)
