"""What is learned from choices: the objective, the descent, and the learners."""
