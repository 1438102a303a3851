"""The orchestrator and everything a person touches."""
