#!/usr/bin/env bash
# Draws the pictures of docs/gallery.md again, each by the line that the page shows.
set -euo pipefail
cd "$(dirname "$0")/../docs/images"
hfield render --size 320x240 --fps 20 --motion-blur 0.5 --force -o top.webp
hfield render --sheet --force -o top.png
hfield render --dark --sheet --force -o top-dark.png
for style in classic flat shaded; do
    hfield render --model quaternions --style "$style" --size 320x240 --sheet --force -o "style-$style.png"
done
hfield figures --format svg -o .
hfield brandt 83 --prime 2 --plot isogenies.svg >/dev/null
hfield domain '(3,-1|QQ)' -o domain-6.svg >/dev/null
hfield domain '(3,-1|QQ)' --dark -o domain-6-dark.svg >/dev/null # of the first page
hfield domain '(2,-13|QQ)' --dark -o domain-26.png >/dev/null
hfield domain '(-1+s-s^2,1+3*s+s^2|QQ[s]/(s^3+s^2-2*s-1))' -o domain-237.png >/dev/null
