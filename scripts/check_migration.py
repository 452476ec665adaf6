"""Check that the modules listed in ``scripts/migration.txt`` shrink until they are removed.

    python -m scripts.check_migration

Each line is a module and the largest number of lines that it may have. The check fails if a listed module has
more lines, if a removed module is still listed, and if the list has grown since the last commit.
"""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
LIST = "scripts/migration.txt"


def read(text: str) -> dict[str, int]:
    """Return the listed modules with their numbers of lines."""
    lines = (line.split() for line in text.splitlines() if line.strip() and line[0] != "#")
    return {path: int(count) for path, count in lines}


def faults(listed: dict[str, int], before: dict[str, int], root: Path) -> list[str]:
    """Return what is wrong with a list and the modules in a folder, one text for each fault."""
    found = [
        f"{path} is new in {LIST}, which only shrinks" for path in listed if path not in before
    ]
    for path, most in listed.items():
        if not (root / path).exists():
            found.append(f"{path} is removed: remove it from {LIST}")
            continue
        count = len((root / path).read_text(encoding="utf-8").splitlines())
        if count > most:
            found.append(f"{path} has {count} lines, {count - most} more than {LIST} allows")
        most_before = before.get(path, most)
        if most > most_before:
            found.append(f"{path} is allowed {most} lines, and was allowed {most_before}")
    return found


def main() -> int:
    """Print the faults; return 1 if there are any."""
    path = ROOT / LIST
    listed = read(path.read_text(encoding="utf-8")) if path.exists() else {}
    command = ["git", "show", f"HEAD:{LIST}"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    before = listed if done.returncode else read(done.stdout)
    found = faults(listed, before, ROOT)
    print("\n".join(found), end="\n" * bool(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
