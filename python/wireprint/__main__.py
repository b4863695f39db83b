"""``python -m wireprint`` is the command."""

from wireprint.cli import main

main(prog_name="wireprint")
