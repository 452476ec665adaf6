"""The process that ``subprocess_limits`` starts: a request on stdin, the decision on stdout."""

import json
import sys
from collections.abc import Iterable
from dataclasses import asdict

from hfield.proving.decide import decide_statement
from hfield.proving.decision import Decision
from hfield.proving.statements.language import read_statement
from hfield.proving.statements.setting import read_setting


def decide_here(
    statement: str,
    field: str | None,
    given: Iterable[str],
    algebra: str | None,
    timeout: float,
) -> Decision:
    """Decide in this process, whatever the risk."""
    setting = read_setting(field, algebra)
    read = read_statement(
        statement, setting.field, tuple(given), setting.letters, setting.constants
    )
    return decide_statement(read, setting, timeout)


def main(memory: int) -> None:
    """Answer the request on standard input, within ``memory`` bytes."""
    try:
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    except (ImportError, ValueError, OSError):  # not a Unix, or a lower limit holds already
        pass
    json.dump(asdict(decide_here(**json.loads(sys.stdin.read()))), sys.stdout)


if __name__ == "__main__":
    main(int(sys.argv[1]))
