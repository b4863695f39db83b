"""A plain layer slicer: what a wire print is compared with."""
