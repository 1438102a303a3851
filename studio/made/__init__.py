"""What the orchestrator gives back, and how it shows itself in a notebook."""
