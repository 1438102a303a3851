"""A study: what learners make of teachers; its recording, its picture, its figure for a paper."""
