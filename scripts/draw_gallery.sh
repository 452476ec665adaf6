#!/usr/bin/env bash
# Draws the pictures of docs/gallery.md again, each by the line that the page shows below it.
set -euo pipefail
cd "$(dirname "$0")/../docs/images"
sed -n 's/^`\(hfield .*\)`$/\1/p' ../gallery.md | while read -r line; do
    echo "$line"
    [[ $line == *" render "* ]] && line+=" --force"
    bash -c "$line" </dev/null >/dev/null
done
hfield domain '(3,-1|QQ)' --dark -o domain-6-dark.svg >/dev/null # of the first page
