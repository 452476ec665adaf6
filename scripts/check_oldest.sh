#!/usr/bin/env bash
# Runs the quick tests, each with the first of its cases: those that use most of the dependencies with the oldest versions that
# pyproject.toml allows, and those that use most of Python with the newest other Python from 3.11 on that is found here (what is not
# found is said). On Pythons between, which seldom break what the newest does not, a few of these run. The peers that only tests need
# stay new. With `all`, all cases of all quick tests run everywhere.
#
#     scripts/check_oldest.sh [all]
set -euo pipefail
cd "$(dirname "$0")/.."

install() { # FOLDER: an environment for each Python there
    python3 -m venv "$1/tools"
    "$1/tools/bin/pip" install --quiet uv
    local uv=$1/tools/bin/uv this minor python
    mkdir -p "$1/environments"
    this=$(python3 -c "import sys; print(sys.executable)")
    if command -v pyenv >/dev/null; then # its shims find only the versions that are asked for
        export PYENV_VERSION=$(pyenv versions --bare | paste -sd:)
    fi
    environment() { # NAME PYTHON CONSTRAINTS
        "$uv" venv --quiet --python "$2" "$folder/environments/$1"
        "$uv" pip install --quiet --python "$folder/environments/$1/bin/python" '.[test]' --constraints "$3"
    }
    "$uv" pip compile --quiet --resolution lowest-direct --python-version 3.11 pyproject.toml -o "$1/oldest.txt"
    environment oldest "$this" "$1/oldest.txt"
    for minor in 11 12 13 14; do
        if ! python=$("python3.$minor" -c "import sys; print(sys.executable)" 2>/dev/null); then
            echo "python3.$minor is not installed here: not tried"
        elif [ "$minor" != "$("$this" -c "import sys; print(sys.version_info.minor)")" ]; then
            environment "3.$minor" "$python" /dev/null
        fi
    done
}

test_all() { # FOLDER [all]: the tests in each environment, beside one another
    local tests=(tests/algebra tests/prover tests/syntax tests/test_executors.py README.md)
    local old=(tests/fields tests/algebra tests/matrices tests/polynomials tests/fuchsian tests/rotation tests/anim tests/test_batches.py README.md)
    local between=(tests/algebra tests/syntax tests/test_executors.py README.md)
    local once=--once path name failed=0 words newest
    [ "${2:-}" = all ] && tests=() && old=() && between=() && once=
    newest=$(find "$1/environments" -mindepth 1 -maxdepth 1 -name '3.*' | sort -V | tail -1)
    declare -A tries
    for path in "$1"/environments/*; do
        name=${path##*/}
        words=("${between[@]}")
        [ "$path" = "$newest" ] && words=("${tests[@]}")
        [ "$name" = oldest ] && words=("${old[@]}")
        # A library's old version may meet a newer one's warnings; ours are errors in the ordinary run.
        "$1/environments/$name/bin/python" -m pytest $once -W ignore "${words[@]}" >"$1/$name.log" 2>&1 &
        tries[$name]=$!
    done
    for name in "${!tries[@]}"; do
        wait "${tries[$name]}" || failed=1
        echo "== $name"
        cat "$1/$name.log"
    done
    return $failed
}

folder=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$folder"' EXIT
install "$folder"
test_all "$folder" "${1:-}"
