#!/usr/bin/env bash
# Exports the course and tries it in Chromium. Usage: page.sh SCANLIGHT-DEMO FOLDER
# FOLDER keeps the page, the screenshots and what npm brings: puppeteer-core drives the browser,
# axe-core judges accessibility.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
program=$1
mkdir -p "$2/screenshots"
folder=$(cd -- "$2" && pwd)

if [[ ! -d $folder/node_modules/axe-core ]]; then
    PUPPETEER_SKIP_DOWNLOAD=1 npm install --prefix "$folder" --no-audit --no-fund --silent puppeteer-core@24 axe-core@4
fi
"$program" --export "$folder/course"
cp "$here/page.mjs" "$folder/page.mjs"  # beside its modules
node "$folder/page.mjs" "$folder/course/index.html" "$folder/screenshots"
