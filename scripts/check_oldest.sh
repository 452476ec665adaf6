#!/usr/bin/env bash
# Runs the quick tests, each with the first of its cases: of the rooms that meet most of the dependencies on the oldest
# of them that pyproject.toml allows, and of those that meet most of Python on every other Python from 3.11 on that is
# found here (what is not found is said). The peers that only tests need stay new. With `all`, all cases of all quick tests run.
set -euo pipefail
cd "$(dirname "$0")/.."

folder=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$folder"' EXIT
this=$(python3 -c "import sys; print(sys.executable)")
"$this" -m venv "$folder/tools"
"$folder/tools/bin/pip" install --quiet uv
uv=$folder/tools/bin/uv
if command -v pyenv >/dev/null; then # its shims find only the versions that are asked for
    export PYENV_VERSION=$(pyenv versions --bare | paste -sd:)
fi

declare -A tries
try() { # NAME PYTHON CONSTRAINTS [TESTS…]: an environment of its own, and the quick tests in it, beside the other tries
    "$uv" venv --quiet --python "$2" "$folder/$1"
    "$uv" pip install --quiet --python "$folder/$1/bin/python" '.[test]' --constraints "$3"
    # A library's old version may meet a newer one's warnings; ours are errors in the ordinary run.
    "$folder/$1/bin/python" -m pytest $once -W ignore "${@:4}" >"$folder/$1.log" 2>&1 &
    tries[$1]=$!
}

"$uv" pip compile --quiet --resolution lowest-direct --python-version 3.11 pyproject.toml -o "$folder/oldest.txt"
rooms=(tests/rings tests/structure tests/proving tests/syntax tests/test_executors.py README.md)
old=(tests/rings tests/fields tests/modules tests/fuchsian tests/rotation tests/anim tests/test_batches.py README.md)
once=--once
[ "${1:-}" = all ] && rooms=() && old=() && once=
try oldest "$this" "$folder/oldest.txt" "${old[@]}"
for minor in 11 12 13 14; do
    if ! python=$("python3.$minor" -c "import sys; print(sys.executable)" 2>/dev/null); then
        echo "python3.$minor is not installed here: not tried"
    elif [ "$minor" != "$("$this" -c "import sys; print(sys.version_info.minor)")" ]; then
        try "3.$minor" "$python" /dev/null "${rooms[@]}"
    fi
done
failed=0
for name in "${!tries[@]}"; do
    wait "${tries[$name]}" || failed=1
    echo "== $name"
    cat "$folder/$name.log"
done
exit $failed
