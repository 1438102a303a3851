"""Two actions of one scene side by side, for a person to choose between."""
