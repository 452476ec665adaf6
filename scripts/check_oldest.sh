#!/usr/bin/env bash
# Runs a third of the quick tests of the rooms that meet most of the dependencies on the oldest of them that
# pyproject.toml allows, then of those that meet most of Python on every other Python from 3.11 on that is found here
# (what is not found is said). The peers that only tests need stay new. With `all`, everything runs all quick tests.
set -euo pipefail
cd "$(dirname "$0")/.."

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
this=$(python3 -c "import sys; print(sys.executable)")
"$this" -m venv "$folder/tools"
"$folder/tools/bin/pip" install --quiet uv
uv=$folder/tools/bin/uv
if command -v pyenv >/dev/null; then # its shims find only the versions that are asked for
    export PYENV_VERSION=$(pyenv versions --bare | paste -sd:)
fi

try() { # NAME PYTHON CONSTRAINTS [TESTS…]: an environment of its own, the quick tests in it
    echo "== $1"
    "$uv" venv --quiet --python "$2" "$folder/$1"
    "$uv" pip install --quiet --python "$folder/$1/bin/python" '.[test]' --constraints "$3"
    # A library's old version may meet a newer one's warnings; ours are errors in the ordinary run.
    "$folder/$1/bin/python" -m pytest -n auto -m "not slow" --every "$every" -W ignore "${@:4}"
}

"$uv" pip compile --quiet --resolution lowest-direct --python-version 3.11 pyproject.toml -o "$folder/oldest.txt"
rooms=(tests/rings tests/structure tests/proving tests/syntax tests/test_executors.py README.md)
old=(tests/rings tests/fields tests/modules tests/fuchsian tests/rotation tests/anim tests/test_batches.py README.md)
every=3
[ "${1:-}" = all ] && rooms=() && old=() && every=1
try oldest "$this" "$folder/oldest.txt" "${old[@]}"
for minor in 11 12 13 14; do
    if ! python=$("python3.$minor" -c "import sys; print(sys.executable)" 2>/dev/null); then
        echo "python3.$minor is not installed here: not tried"
    elif [ "$minor" != "$("$this" -c "import sys; print(sys.version_info.minor)")" ]; then
        try "3.$minor" "$python" /dev/null "${rooms[@]}"
    fi
done
