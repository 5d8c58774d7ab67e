#!/usr/bin/env bash
# Runs scripts/format.sh --check where its tool is the version that decides. Exit code 77: not run.
# Usage: format_test.sh ROOT
set -euo pipefail
cd "$1"
not_run() {
  echo "format: not checked, because $1."
  exit 77
}
tool=$(command -v clang-format-14 || command -v clang-format) ||
  not_run "clang-format is missing (package clang-format)"
version=$("$tool" --version)
[[ $version == *"version 14."* ]] ||
  not_run "clang-format 14 decides, and this machine has: $version"
exec scripts/format.sh --check
