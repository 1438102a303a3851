"""What recordings, pictures and texts share: colours, words and round numbers."""
