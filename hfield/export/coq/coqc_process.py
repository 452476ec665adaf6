"""Run ``coqc`` with bounds of time and memory, as a process that ends with its parent."""

import os
import resource
import signal
import sys

SECONDS, MEMORY = 300.0, 2048  # of one run, by default; memory in MiB
MAX_WRITTEN = 1 << 28  # bytes of a file


def main(parent: str, seconds: str, memory: str, *command: str) -> None:
    """Run a command with limits of CPU seconds and MiB of memory, as long as ``parent`` is alive."""
    bounds = {
        resource.RLIMIT_CPU: int(seconds),
        resource.RLIMIT_AS: int(memory) << 20,
        resource.RLIMIT_FSIZE: MAX_WRITTEN,
        resource.RLIMIT_CORE: 0,
    }
    for what, most in bounds.items():
        _, hard = resource.getrlimit(what)
        most = most if hard == resource.RLIM_INFINITY else min(most, hard)
        resource.setrlimit(what, (most, most))
    if sys.platform == "linux":  # elsewhere an orphan ends when its seconds are over
        import ctypes

        end_with_parent = 1  # PR_SET_PDEATHSIG
        ctypes.CDLL(None).prctl(end_with_parent, signal.SIGKILL)
        if os.getppid() != int(parent):
            sys.exit("the process that asked has ended")
    try:
        os.execv(command[0], command)
    except OSError as error:
        sys.exit(f"{command[0]}: {error.strerror}")


if __name__ == "__main__":
    main(*sys.argv[1:])
