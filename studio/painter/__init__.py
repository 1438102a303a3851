"""The painter: pictures and films, drawn without a display."""
