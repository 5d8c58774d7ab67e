#!/usr/bin/env bash
# Formats every C++ and GLSL file of the project in place; with --check, changes nothing and fails where one
# is not formatted. clang-format 14 decides; other versions differ in small things.
set -euo pipefail
cd "$(dirname "$0")/.."
tool=$(command -v clang-format-14 || command -v clang-format) || {
  echo "format: clang-format is missing. Install the package clang-format." >&2
  exit 3
}

# list_files PATTERN...: those of the project that are there, each ended by a zero byte
list_files() {
  local pattern patterns=()
  for pattern in "$@"; do
    patterns+=(-o -name "$pattern")
  done
  find chapters common scripts shaders tests visualizer -type f \( "${patterns[@]:1}" \) -print0
}

# in_batches COMMAND...: with the files of standard input, on all processors
in_batches() { xargs -0 -r -n 24 -P "$(nproc)" "$@"; }

# The GLSL of this project reads as C++ to the formatter.
formatted_glsl() { "$tool" --assume-filename="$PWD/${1%.*}.cpp" <"$1"; }

check() {
  local status=0 file
  list_files '*.cpp' '*.h' | in_batches "$tool" --dry-run -Werror || status=1
  while IFS= read -r -d '' file; do
    formatted_glsl "$file" | cmp -s "$file" - || {
      echo "$file: is not formatted."
      status=1
    }
  done < <(list_files '*.glsl' '*.frag' '*.vert')
  [ $status -eq 0 ] || echo "format: not every file is formatted. Run scripts/format.sh."
  return $status
}

format() {
  local file text
  list_files '*.cpp' '*.h' | in_batches "$tool" -i
  while IFS= read -r -d '' file; do
    text=$(formatted_glsl "$file" && echo .) # the dot keeps the empty lines at the end
    printf '%s' "${text%.}" | cmp -s "$file" - || printf '%s' "${text%.}" >"$file"
  done < <(list_files '*.glsl' '*.frag' '*.vert')
}

if [ "${1:-}" = --check ]; then
  check
else
  format
fi
