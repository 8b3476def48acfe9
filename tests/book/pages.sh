#!/bin/sh
# The web book in a real browser: no page may have an error, a broken link or picture, a request to another
# host or a serious fault of accessibility, and what one can do there works. See book/test.mjs.
# Ends with 77 where something that it needs is missing.
set -eu
cd "$(dirname "$0")/../.."

skip() {
    echo "skipped: $*"
    exit 77
}

for tool in node npm; do
    command -v "$tool" >/dev/null || skip "$tool is missing: install Node.js 20 or newer, with npm"
done
[ "$(node -p 'parseInt(process.versions.node)')" -ge 20 ] || skip "Node.js is older than 20"
for browser in "${CHROMIUM:-chromium}" chromium-browser google-chrome ''; do
    [ -n "$browser" ] || skip "Chromium is missing: install it, or set CHROMIUM to a browser of its kind"
    ! browser=$(command -v "$browser") || break
done
if [ ! -d book/node_modules/playwright-core ] ||
    [ -n "$(find book/package-lock.json -newer book/node_modules/.package-lock.json)" ]; then
    npm --prefix book ci --no-audit --no-fund || skip "npm could not get the packages that book/package-lock.json names"
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
node book/build.mjs "$folder/book"
node book/test.mjs "$folder/book" "$browser"
