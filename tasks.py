"""The tasks of this project: ``python tasks.py NAME…``; without a name, what CI runs first.

They use the Python that runs them, with the extra ``dev`` installed (``pip install -e '.[dev]'``).
"""

import subprocess
import sys

TASKS = {
    "format": ["ruff", "format", "--check", "."],
    "lint": ["ruff", "check", "."],
    "names": ["scripts.check_names"],
    "types": ["mypy"],
    "test": ["pytest", "-n", "auto"],
    "coverage": ["coverage", "run", "-m", "pytest", "--runslow"],
    "covered": ["coverage", "report", "--skip-covered", "--sort=cover"],
    "docs": [
        "sphinx",
        "-q",
        "-W",
        "--keep-going",
        "-b",
        "html",
        "-d",
        "docs/_build",
        "docs",
        "hfield/site",
    ],
    "gallery": ["scripts.draw_gallery"],
    "methods": ["scripts.list_methods"],
}


def main(names: list[str]) -> int:
    """Run the tasks named, all of them without a name; stop at the first that fails."""
    for name in names or ("format", "lint", "names", "types", "test"):
        if name not in TASKS:
            print(f"there is no task {name!r}; the tasks are {', '.join(TASKS)}", file=sys.stderr)
            return 2
        print(f"== {name}: python -m {' '.join(TASKS[name])}", flush=True)
        status = subprocess.run([sys.executable, "-m", *TASKS[name]], check=False).returncode
        if status:
            return status
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
