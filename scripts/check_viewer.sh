#!/usr/bin/env bash
# Lets a browser look at the web page that `hfield render -o top.html` writes, and at the site's page that checks
# certificates: the tests that drive headless Chromium. Run it in an environment where hfield and pytest are installed. Debian's chromium is
# installed where it is missing and where that is possible; where it is not, the tests are skipped and
# say so (REQUIRE_CHROMIUM=1 makes that an error).
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v chromium >/dev/null && [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    echo "installing chromium (about 400 MB)"
    { apt-get update -qq && apt-get install -qq -y --no-install-recommends chromium; } >/dev/null || true
fi
if ! command -v chromium >/dev/null; then
    echo "chromium is missing and could not be installed: what it draws is not checked" >&2
    [ -z "${REQUIRE_CHROMIUM:-}" ] || exit 1
fi
# axe-core looks for what keeps people out of the pages; the test finds it through NODE_PATH.
if command -v npm >/dev/null; then
    npm install --silent --no-save --prefix "${TMPDIR:-/tmp}/hfield-axe" axe-core >/dev/null || true
    export NODE_PATH="${TMPDIR:-/tmp}/hfield-axe/node_modules${NODE_PATH:+:$NODE_PATH}"
fi
python -m pytest -rs tests/anim/test_page_accessibility.py tests/anim/test_viewer.py tests/docs/test_checker_page.py tests/fuchsian/test_page_in_a_browser.py
