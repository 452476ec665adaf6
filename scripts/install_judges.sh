#!/usr/bin/env bash
# Installs the judges that pip does not bring, where that is possible: Coq (about 1 GB) and Chromium (half of one) from Debian, as root; from npm
# axe-core, which looks for what keeps people out of pages, and Pyodide, which runs the checker in them. Tests find them; what is missing
# is said here, and the tests that ask it skip (REQUIRE_JUDGES=1 makes that an error).
set -euo pipefail
cd "$(dirname "$0")/.."

missing=0
lacking() {
    echo "$1 is missing and could not be installed: what it checks is skipped" >&2
    missing=1
}
browser() { command -v chromium || command -v chromium-browser || command -v google-chrome; }
packages=()
command -v coqc >/dev/null || packages+=(coq)
browser >/dev/null || packages+=(chromium)
if [ ${#packages[@]} -gt 0 ] && [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    { apt-get update -qq && apt-get install -qq -y --no-install-recommends "${packages[@]}"; } >/dev/null || true
fi
command -v coqc >/dev/null || lacking Coq
browser >/dev/null || lacking Chromium
if command -v npm >/dev/null; then npm install --silent --prefix docs/_build axe-core pyodide >/dev/null || true; fi
for name in axe-core pyodide; do
    [ -d "docs/_build/node_modules/$name" ] || lacking "$name"
done
exit $((missing && ${REQUIRE_JUDGES:-0}))
