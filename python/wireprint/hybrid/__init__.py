"""Wire prints whose marked regions are stacked layers (paper, "Additional detail")."""
