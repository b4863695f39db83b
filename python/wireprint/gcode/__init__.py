"""Stage 6: a toolpath becomes the text of a G-code file."""
