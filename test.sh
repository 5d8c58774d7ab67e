#!/usr/bin/env bash
# Builds and tests Raysteps.
#
#   ./test.sh                     installs what is missing, builds, and runs every test
#   ./test.sh 06                  builds and tests one chapter
#   ./test.sh hard_cases          the same for another subject: a module, book, course, ...
#   ./test.sh PRESET              what takes long, or another compiler: debug, headless, clang, sanitize, long, odr
#   ./test.sh --no-install ...    installs nothing: lists what is missing, and stops if anything is
#   ./test.sh --help              says this
#
# The last lines say how many tests ran, and where the time went.
set -euo pipefail
cd "$(dirname "$0")"
. scripts/set_up.sh

install=
case "${1:-}" in
--help | -h)
  sed -n '2,11s/^# \{0,1\}//p' test.sh
  exit 0
  ;;
--no-install)
  install=--no-install
  shift
  ;;
esac
if [ $# -gt 1 ]; then
  echo "test.sh: $* is more than one chapter or preset; see --help." >&2
  exit 2
fi

table=
status=0
# step NAME COMMAND...: its seconds go into the table
step() {
  local name=$1 begin=$SECONDS
  shift
  "$@" || status=$?
  table+=$(printf '%8d s  %s' $((SECONDS - begin)) "$name")$'\n'
}

log=build/test.log
# Longest first where CMake knows it, on all processors.
run_tests() { ctest --preset "$1" --parallel "$(nproc)" "${@:2}" | tee $log; }

# add_labels: what ctest says that each label took, the longest first
add_labels() {
  [ ! -s $log ] || table+=$(sed -n 's/^\([a-z_0-9]*\) *= *\([0-9.]*\) sec\*proc (\(.*\))$/\2 \1 \3/p' $log |
    sort -rn | awk '{ printf "%12d s of a processor  %s: %s %s\n", $1, $2, $3, $4 }')$'\n'
}

finish() {
  echo
  echo "Where the time went:"
  printf '%s%8d s  altogether\n' "$table" "$SECONDS"
  if [ $status -ne 0 ]; then
    echo "test.sh: something above failed." >&2
  fi
  exit $status
}

target=all
labels=()
preset=default
case "${1:-}" in
"") ;;
debug | headless | clang | sanitize | odr) preset=$1 ;;
long) tests=long ;;
*)
  target=tests_$1
  labels=(--label-regex "^$1\$")
  ;;
esac

rm -f $log
step "installing what is missing" set_up test $install
step configuring cmake --preset $preset
if [ $target != all ] && ! cmake --build --preset $preset --target help | grep -q "^$target:"; then
  echo "test.sh: there are no tests $1. There are$(cmake --build --preset $preset --target help |
    sed -n 's/^tests_\([a-z0-9_]*\):.*/ \1/p' | sort | tr -d '\n'); and see --help." >&2
  exit 2
fi
[ $status -ne 0 ] || step compiling cmake --build --preset $preset --target $target
# Where a part does not build, the tests of the rest still say something.
[ $preset = odr ] || step testing run_tests "${tests:-$preset}" "${labels[@]}"
add_labels
finish
