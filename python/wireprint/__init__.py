"""Turns a 3D model into a wire print."""
