"""The picture of a scene and its film."""
