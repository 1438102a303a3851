"""The figure of a study for a paper, drawn with matplotlib."""
