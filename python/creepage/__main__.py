"""The command `creepage`; also `python -m creepage`."""

from __future__ import annotations

import signal
import sys

from ._creepage import command


def main() -> int:
    """Runs the command with the arguments of the program; gives the exit code."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # Ctrl-C ends it, as any command
    return command(["creepage", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
