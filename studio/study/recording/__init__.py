"""The recording of a study: how it is written, what it holds, and how it is read back."""
