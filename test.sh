#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test; the last lines say how many ran.
#
#   ./test.sh [--no-install]
set -euo pipefail
cd "$(dirname "$0")"
. scripts/set_up.sh

if [ $# -gt 1 ] || { [ $# -eq 1 ] && [ "$1" != --no-install ]; }; then
  echo "test.sh: $* is not known. The only option is --no-install." >&2
  exit 2
fi
set_up test "${1:-}"
status=0
cmake --workflow --preset fuzz || status=1
cmake --workflow --preset default || status=1
if [ $status -ne 0 ]; then
  echo "test.sh: something above failed." >&2
fi
exit $status
