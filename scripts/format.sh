#!/usr/bin/env bash
# Formats every C++ and GLSL file of the project in place; with --check, changes nothing and fails where one
# is not formatted. clang-format 14 decides; other versions differ in small things.
set -euo pipefail
cd "$(dirname "$0")/.."
tool=$(command -v clang-format-14 || command -v clang-format) || {
  echo "format: clang-format is missing. Install the package clang-format." >&2
  exit 3
}
status=0
formatted=$(mktemp)
trap 'rm -f "$formatted"' EXIT
while IFS= read -r -d '' file; do
  [ -f "$file" ] || continue
  # The GLSL of this project reads as C++ to the formatter.
  "$tool" --assume-filename="$PWD/${file%.*}.cpp" <"$file" >"$formatted"
  if cmp -s "$file" "$formatted"; then
    continue
  elif [ "${1:-}" = --check ]; then
    echo "format: $file is not formatted. Run scripts/format.sh."
    status=1
  else
    cat "$formatted" >"$file"
  fi
done < <(find chapters common shaders tests \( -name '*.cpp' -o -name '*.h' -o -name '*.glsl' -o -name '*.frag' -o -name '*.vert' \) -print0)
exit $status
