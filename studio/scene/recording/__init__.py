"""The recording of a scene: how it is written, what it holds, and how it is read back."""
