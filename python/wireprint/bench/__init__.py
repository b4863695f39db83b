"""Many models at once: every condition and the certificate of each, on one machine or many.

`plan` finds the models, `task` evaluates one, `pool` hands tasks to workers (`local` processes or
a `cluster`), `table` keeps the rows, and `summary` and `histogram` tell what they amount to.
"""
