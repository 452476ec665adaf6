#!/usr/bin/env bash
# Lets Coq judge: the tests that need coqc (the ledger, certificates of every kind, forged ones), and a
# share of all the ledger's certificates. Run it in an environment where hfield and pytest are installed.
# Debian's coq is installed where it is missing and where that is possible; where it is not, all is
# skipped and says so (REQUIRE_COQ=1 makes that an error). EVERY=1 judges all certificates.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v coqc >/dev/null && [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    echo "installing coq (about 1 GB)"
    { apt-get update -qq && apt-get install -qq -y --no-install-recommends coq; } >/dev/null || true
fi
if ! command -v coqc >/dev/null; then
    echo "coqc is missing and could not be installed: what it checks is skipped" >&2
    [ -z "${REQUIRE_COQ:-}" ] || exit 1
    exit 0
fi
python -m pytest -rs tests/coq/test_coqc.py
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python -m hfield verify --certificates "$folder" >/dev/null
python scripts/judge_with_coq.py "$folder" --every "${EVERY:-17}"
