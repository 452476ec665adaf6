"""The worker process of ``decide``: it reads a request and writes the decision."""

import json
import pickle
import sys

from hfield.prover.decide import decide_in_process, read_question


def main(memory: int) -> None:
    """Answer the request on standard input, within ``memory`` bytes."""
    try:
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    except (ImportError, ValueError, OSError):  # not a Unix, or a lower limit holds already
        pass
    question = read_question(**json.loads(sys.stdin.read()))
    pickle.dump(decide_in_process(question), sys.stdout.buffer)


if __name__ == "__main__":
    main(int(sys.argv[1]))
