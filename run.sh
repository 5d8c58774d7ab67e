#!/usr/bin/env bash
# Builds Raysteps and renders with it.
#
#   ./run.sh                      installs what is missing, builds, and renders every chapter into out/
#   ./run.sh 03 [OPTION...]       runs one chapter's program with its options; --help lists them
#   ./run.sh hard_cases [...]     tries every method at every hard case, and prints who passes
#   ./run.sh check --tree FILE    says what is wrong with a tree that another program built (docs/tree_files.md)
#   ./run.sh shrink --command ... reduces a ray that another engine gets wrong, or a fault of a tree, to a few triangles
#   ./run.sh conformance --command ...  runs the hard cases over any ray tracer, and judges its hits exactly
#   ./run.sh view [SCENE ...]     shows a structure and how a ray walks through it, step by step
#   ./run.sh book [--port N]      makes the book, and serves it on this machine (127.0.0.1:8000)
#   ./run.sh book --pdf           makes the book, and prints it into one PDF
#   ./run.sh book --zip           makes the book, and packs it and the playground into one file
#   ./run.sh --no-install ...     installs nothing: lists what is missing, and stops if anything is
#   ./run.sh --help               says this
set -euo pipefail
called_from=$PWD
cd "$(dirname "$0")"
. scripts/set_up.sh

install=
case "${1:-}" in
--help | -h)
  sed -n '2,15s/^# \{0,1\}//p' run.sh
  exit 0
  ;;
--no-install)
  install=--no-install
  shift
  ;;
esac

# The small conformance suite is there already, and Python is all that it needs.
if [ "${1:-}" = conformance ] && [[ " $* " != *" --rays "* ]]; then
  script=$PWD/scripts/conformance
  shift
  cd "$called_from"
  exec python3 -B "$script" "$@"
fi

chapter=
script=()
kind=run
if [ "${1:-}" = view ] || [ "${1:-}" = book ]; then
  kind=$1
  shift
elif [ "${1:-}" = shrink ]; then
  chapter=check
  script=(shrink --check)
  shift
elif [ "${1:-}" = conformance ]; then
  chapter=hard_cases
  script=(conformance --generator)
  shift
elif [ $# -gt 0 ]; then
  for folder in chapters/"$1"*/; do
    [ -d "$folder" ] && [[ $1 =~ ^[0-9][0-9] ]] && chapter=$(basename "$folder")
  done
  [[ $1 =~ ^[a-z_]+$ ]] && [ -d "chapters/$1" ] && chapter=$1
  if [ -z "$chapter" ]; then
    echo "run.sh: there is no chapter or option $1. The chapters: $(cd chapters && ls -d */ | tr -d / | xargs); see --help." >&2
    exit 2
  fi
  shift
fi

# What a script says of itself needs no program.
if [[ " $* " =~ " --help " || " $* " =~ " -h " ]]; then
  [ $kind != book ] || exec python3 -B scripts/book serve --help
  [ ${#script[@]} -eq 0 ] || exec python3 -B "scripts/${script[0]}" --help
fi

set_up $kind $install
# Tests are configured where they can be built, and never built here.
tests=$(can_test && echo ON || echo OFF)
log=build/configure.log
mkdir -p build
if ! cmake --preset default -DRAYSTEPS_TESTS="$tests" >$log 2>&1; then
  cat $log >&2
  exit 3
fi

# build_and_run TARGET PROGRAM OPTION...
build_and_run() {
  local target=$1 program=$PWD/$2
  shift 2
  if [ ! -x "$program" ]; then
    echo "run.sh: building $target, which takes some minutes the first time (see build/build.log)" >&2
  fi
  cmake --build --preset default --target "$target" >build/build.log 2>&1 || {
    cat build/build.log >&2
    exit 1
  }
  local project=$PWD
  cd "$called_from"
  if [ ${#script[@]} -gt 0 ]; then
    exec python3 -B "$project/scripts/${script[0]}" "${script[1]}" "$program" "$@"
  fi
  exec "$program" "$@"
}

if [ $kind = book ]; then
  echo "run.sh: making the book; its programs take some minutes the first time" >&2
  cmake --build --preset default --target book
  exec python3 -B scripts/book serve "$@"
elif [ $kind = view ]; then
  build_and_run visualizer build/default/visualizer/visualizer "$@"
elif [ -n "$chapter" ]; then
  build_and_run "$chapter" "build/default/chapters/$chapter/$chapter" "$@"
fi

# Chapter after chapter, so that the first pictures come while most of the project is not compiled yet: first
# those that are cheap to compile and to render. Whatever is not named here comes last.
echo "run.sh: building and rendering; the first picture takes about a minute, all of them some minutes" >&2
for chapter in 01_rays 06_bvh 04_grid 05_kd_tree 03_shading 09_effects 08_accuracy 07_compare 10_speed 11_paths; do
  cmake --build --preset default --target "pictures_$chapter"
done
cmake --build --preset default --target pictures
echo
echo "Rendered:"
find out -name '*.png' | sort | sed 's/^/  /'
