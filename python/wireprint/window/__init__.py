"""The window: a page on this machine that shows a model, takes the brush, and answers in prints."""
