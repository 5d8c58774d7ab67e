#!/usr/bin/env bash
# Builds Raysteps and renders with it.
#
#   ./run.sh                      installs what is missing, builds, and renders every chapter into out/
#   ./run.sh 03 [OPTION...]       runs one chapter's program with its options; --help lists them
#   ./run.sh --no-install ...     installs nothing: lists what is missing, and stops if anything is
#   ./run.sh --help               says this
set -euo pipefail
called_from=$PWD
cd "$(dirname "$0")"
. scripts/set_up.sh

install=
case "${1:-}" in
--help | -h)
  sed -n '2,7s/^# \{0,1\}//p' run.sh
  exit 0
  ;;
--no-install)
  install=--no-install
  shift
  ;;
esac

chapter=
if [ $# -gt 0 ]; then
  for folder in chapters/"$1"*/; do
    [ -d "$folder" ] && [[ $1 =~ ^[0-9][0-9] ]] && chapter=$(basename "$folder")
  done
  if [ -z "$chapter" ]; then
    echo "run.sh: there is no chapter $1. Take one of: $(cd chapters && echo [0-9]*/)" >&2
    exit 2
  fi
  shift
fi

set_up run $install
log=build/configure.log
mkdir -p build
if ! cmake --preset default -DRAYSTEPS_TESTS=OFF >$log 2>&1; then
  cat $log >&2
  exit 3
fi

if [ -n "$chapter" ]; then
  # Quiet where nothing is to be built, so that a picture's own words stand alone.
  cmake --build --preset default --target "$chapter" >build/build.log 2>&1 || {
    cat build/build.log >&2
    exit 3
  }
  program=$PWD/build/default/chapters/$chapter/$chapter
  cd "$called_from"
  exec "$program" "$@"
fi

cmake --build --preset default --target pictures
echo
echo "Rendered:"
find out -name '*.png' | sort | sed 's/^/  /'
