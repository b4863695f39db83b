"""The head of one's own printer: measured, drawn, and tried with a gauge."""
