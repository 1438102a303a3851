"""The recording of a comparison: how it is written, what it holds, and how it is read back."""
