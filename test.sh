#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test; the last lines say how many ran.
#
#   ./test.sh [--no-install]
set -euo pipefail
cd "$(dirname "$0")"
. scripts/set_up.sh

if [ $# -gt 0 ] && [ "$1" != --no-install ]; then
  echo "test.sh: the option $1 is not known. The only one is --no-install." >&2
  exit 2
fi
set_up test "${1:-}"
cmake --workflow --preset fuzz
cmake --workflow --preset default
