#!/usr/bin/env bash
# What a person may rely on whatever --context is: each gives a core profile, and the same pictures.
# Each context has a process of its own, as in the programs. Exit code 77: not run.
# Usage: contexts_test.sh core CORE_CONTEXT KIND
#        contexts_test.sh same PROGRAM KIND OTHER_KIND
#        contexts_test.sh automatic PROGRAM
set -euo pipefail
unset DISPLAY WAYLAND_DISPLAY

fail() {
  echo "contexts: $*" >&2
  exit 1
}

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# in_context KIND COMMAND...: with a display where the kind needs one.
in_context() {
  local kind=$1
  shift
  if [ "$kind" = window ]; then
    command -v xvfb-run >/dev/null || fail "xvfb-run is missing. Install the package xvfb, or leave this out with ctest -LE contexts."
    xvfb-run -a "$@"
  else
    "$@"
  fi
}

# render PROGRAM KIND SCENE
render() {
  in_context "$2" "$1" --context "$2" --scene "$3" --size 64x48 --out "$folder/$2" >"$folder/$2.log" ||
    fail "$3 cannot be rendered with --context $2"
}

renderer() { grep '^OpenGL' "$folder/$1.log"; }

test_core() { in_context "$2" "$1" "$2"; }

test_same() {
  local scene
  for scene in cornell_box mirrors; do
    render "$1" "$2" "$scene"
    render "$1" "$3" "$scene"
    if [ "$(renderer "$2")" != "$(renderer "$3")" ]; then
      # Two drivers may divide and take roots with other roundings.
      echo "contexts: not compared, because $2 and $3 run on different renderers:"
      renderer "$2"
      renderer "$3"
      exit 77
    fi
    cmp "$folder/$2/$scene.pfm" "$folder/$3/$scene.pfm" ||
      fail "$2 and $3 give different pictures of $scene"
  done
}

test_automatic() {
  render "$1" auto cornell_box
  [ -s "$folder/auto/cornell_box.png" ] || fail "there is no picture"
  renderer auto
}

mode=$1
shift
"test_$mode" "$@"
