"""The command line, the same as the `flexure` binary."""

import signal
import sys

from flexure._native import run_command_line


def main() -> None:
    # The engine stops cleanly on Ctrl-C by itself and keeps what it has.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(run_command_line(sys.argv[1:]))


if __name__ == "__main__":
    main()
