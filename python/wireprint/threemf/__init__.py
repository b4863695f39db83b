"""3MF files: a guarded archive, its model parts, what they place, and what is painted on it."""
