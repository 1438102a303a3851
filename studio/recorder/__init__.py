"""The recorder: what a person opens in the Rerun viewer."""
