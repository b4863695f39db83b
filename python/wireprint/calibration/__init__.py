"""Small prints that make a forecast true for a machine, and the fit of what they tell."""
