"""The picture of a comparison and its film."""
