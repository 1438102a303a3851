"""Studies of learners: who learns what from whom, put to the test on held-out scenes."""
