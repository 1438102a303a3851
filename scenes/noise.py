"""Everything random about a rollout, drawn from one seed.

Each rollout has a random stream of its own: Philox, a counter-based generator (Salmon et al.,
"Parallel random numbers: as easy as 1, 2, 3", SC 2011), keyed by seed, scene and rollout. What a
rollout draws therefore depends on nothing else: not on how many rollouts there are, in what
order, on how many threads, or under which action. The actions of a scene share it (common random
numbers), so that a difference between two actions is never a difference of luck.
"""
