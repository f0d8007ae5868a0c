"""The command `orbearing` of a wheel: the command line within this process."""

from __future__ import annotations

import signal
import sys


def main() -> int:
    """Returns the exit code: 0 done, 1 the computation failed, 2 bad input or usage."""
    # Without results of its own to keep a command ends at once, as the program does.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    from orbearing import _core

    code = _core.command_line(sys.argv[1:])
    sys.stdout.flush()
    return code


if __name__ == "__main__":
    sys.exit(main())
