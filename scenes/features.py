"""What a rollout is worth describing by: five features."""

FEATURES = ("clearance", "deviation", "progress", "smoothness", "collisions")
"""The features φ, in the order of every feature axis and of the reward θ."""
