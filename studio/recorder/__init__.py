"""The medium Rerun: tools that every kind of recording is written and read with."""
