#!/bin/sh
# The web book in a real browser: no page may have an error, a broken link or picture, a request to another
# host or a serious fault of accessibility, and everything that you can do there must work: see book/test.mjs.
# Before that, it runs the tests that need no browser.
# pages.sh FOLDER SAMPLES  makes the book in the folder; SAMPLES makes samples of the learner's page to share
# pages.sh FOLDER          looks how soon the book in the folder is there: nothing else may run meanwhile
# Ends with 77 if something that it needs is missing.
set -eu
cd "$(dirname "$0")/../.."

skip() {
    echo "skipped: $*"
    exit 77
}

for tool in node npm; do
    command -v "$tool" >/dev/null || skip "$tool is missing: install Node.js 18 or newer, with npm"
done
[ "$(node -p 'parseInt(process.versions.node)')" -ge 18 ] || skip "Node.js is older than 18"
if [ $# -gt 1 ]; then
    if [ ! -d book/node_modules/playwright-core ] ||
        [ -n "$(find book/package-lock.json -newer book/node_modules/.package-lock.json)" ]; then
        npm --prefix book ci --no-audit --no-fund --fetch-retries=1 --fetch-timeout=30000 ||
            skip "npm could not get the packages that book/package-lock.json names"
    fi
    node book/forms.mjs
    node book/yours_test.mjs
    node book/serve_test.mjs
    if command -v "${CXX:-c++}" >/dev/null; then node book/live/native.mjs; fi
fi

for browser in "${CHROMIUM:-chromium}" chromium-browser google-chrome ''; do
    [ -n "$browser" ] || skip "Chromium is missing: install it, or set CHROMIUM to a browser of its kind"
    ! browser=$(command -v "$browser") || break
done

if [ $# -lt 2 ]; then
    [ -d "$1" ] || skip "the book was not made"
    ONLY='is soon there' node book/test.mjs "$1" "$browser"
    exit
fi

samples=$(mktemp -d)
trap 'rm -rf "$samples"' EXIT
rm -rf "$1"
node book/build.mjs "$1" --url https://example.org/book
"$2" "$samples"
EXCEPT='is soon there' node book/test.mjs "$1" "$browser" "$samples"
