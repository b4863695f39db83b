"""The command, as tests call it."""

from click.testing import CliRunner

from wireprint import cli


def run(*arguments):
    return CliRunner().invoke(cli.main, [str(argument) for argument in arguments])
