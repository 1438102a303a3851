"""The picture of a study and its film."""
