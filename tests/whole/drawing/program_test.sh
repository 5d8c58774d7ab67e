#!/usr/bin/env bash
# Runs the visualizer without a display, or in a real window on a display without a screen, with keys and a mouse.
# Usage: program_test.sh VISUALIZER SCENARIO, a function below.
set -euo pipefail

# A slow machine gets its time: every wait ends as soon as what it waits for is there.
most_seconds=120
visualizer=$1
folder=$(mktemp -d)
cd "$folder"

fail() {
  echo "visualizer test: $*" >&2
  cat stdout stderr >&2 2>/dev/null || true
  exit 1
}

need() {
  command -v "$1" >/dev/null || {
    echo "visualizer test: $1 is missing. Install the package $2, or leave this test out with ctest -LE visualizer." >&2
    exit 1
  }
}

close_all() {
  for process in ${program:-} ${display_server:-}; do
    kill "$process" 2>/dev/null || true
    wait "$process" 2>/dev/null || true
  done
  rm -rf "$folder"
}
trap close_all EXIT

# wait_until "WHAT IT WAITS FOR" COMMAND...
wait_until() {
  local what=$1 end=$((SECONDS + most_seconds))
  shift
  until "$@"; do
    [ -z "${program:-}" ] || kill -0 "$program" 2>/dev/null || fail "the program ended before $what"
    [ $SECONDS -lt $end ] || fail "waited $most_seconds seconds in vain for $what"
    sleep 0.1
  done
}

# run EXIT_CODE OPTION...
run() {
  local expected=$1 code=0
  shift
  env -u DISPLAY "$visualizer" "$@" >stdout 2>stderr || code=$?
  [ $code -eq "$expected" ] || fail "the exit code is $code instead of $expected for: $*"
}
says() { grep -q -- "$1" stdout stderr || fail "nothing is said of \"$1\""; }
is_png() { [ "$(head -c 4 "$1" | tail -c 3)" = PNG ]; }

writes_a_picture_without_a_display() {
  run 0 mirrors --size 64 --pixel 25,38
  says "there is no display"
  is_png out/view/mirrors_bvh4.png || fail "no picture was written"
  [ ! -s stderr ] || [ "$(wc -l <stderr)" -eq 1 ] || fail "there is more than one sentence"
  run 0 mirrors --size 64 --pixel 25,38 --structure grid --animate steps
  is_png steps/step_0001.png || fail "there is no picture of step 1"
  [ "$(find steps -name '*.png' | wc -l)" -gt 3 ] || fail "there are too few pictures of steps"
}

says_what_is_wrong() {
  run 2 mirrors --structure octree
  says octree
  run 2 no_such_file.obj
  says no_such_file.obj
  run 2 mirrors --pixel 9999,0
  says "--pixel 9999,0"
  run 2 mirrors --screenshot /proc/no/such/place.png
  says /proc/no/such/place.png
  run 2 mirrors --export picture.stl
  says .vtkjs
  run 0 --help
  says --hard-case
}

opens_its_own_state() {
  run 0 mirrors --size 64 --pixel 25,38 --structure kd_ropes --step 4 --save-state a.json --screenshot a.png
  run 0 --state a.json --screenshot b.png
  grep -q '"step": 3' a.json || fail "step 4 is not in the file"
  grep -q kd_ropes a.json || fail "the structure is not in the file"
  is_png b.png || fail "no picture was written"
}

has_window() {
  window=$(xdotool search --onlyvisible --name '^Raysteps: mirrors' 2>/dev/null | head -n 1)
  [ -n "$window" ]
}

# open_window OPTION...: on a display of its own, and waits until it answers keys.
open_window() {
  need Xvfb xvfb
  need xdotool xdotool
  # A number of its own: a server that ends removes the socket of one that has just taken the same number.
  Xvfb ":$((100 + $$ % 50000))" -displayfd 3 -noreset -screen 0 1000x800x24 -nolisten tcp 3>display 2>xvfb &
  display_server=$!
  wait_until "a display" test -s display
  DISPLAY=:$(cat display)
  export DISPLAY
  "$visualizer" mirrors --size 64 --window-size 800x600 "$@" >stdout 2>stderr &
  program=$!
  wait_until "a window" has_window
  xdotool mousemove 300 200
  save 1
}

state_file() { [ "$1" -eq 1 ] && echo "out/view/mirrors_bvh4.json" || echo "out/view/mirrors_bvh4_$1.json"; }

# save NUMBER: K, which writes the state.
save() {
  local file
  file=$(state_file "$1")
  xdotool key k
  wait_until "state $1" test -s "$file"
}

# has NUMBER TEXT: whether the state says so.
has() { tr -d ' \n' <"$(state_file "$1")" | grep -q -- "$2" || fail "state $1 says no $2: $(cat "$(state_file "$1")")"; }

quit() {
  local code=0
  xdotool key q
  for _ in $(seq 1 100); do
    kill -0 "$program" 2>/dev/null || break
    sleep 0.1
  done
  kill -0 "$program" 2>/dev/null && fail "Q does not end the program"
  wait "$program" || code=$?
  program=
  [ $code -eq 0 ] || fail "the exit code is $code"
}

steps_with_keys() {
  open_window --pixel 25,38
  has 1 '"step":-1'
  xdotool key Home n n Right p
  save 2
  has 2 '"step":2'
  xdotool key End w c v b
  save 3
  has 3 '"step":-1'
  has 3 '"model":"wireframe"'
  has 3 '"color":"triangles"'
  has 3 '"show":"tested"'
  has 3 '"table":true'
  xdotool key ctrl+z ctrl+z
  save 4
  has 4 '"table":false'
  has 4 '"show":"visited"'
  has 4 '"color":"triangles"'
  xdotool key ctrl+y
  save 5
  has 5 '"table":false'
  has 5 '"show":"tested"'
  # On from the last step, round: to the hit's test. Its cell is marked, then its parent.
  xdotool key Home a Return
  save 6
  ! tr -d ' \n' <"$(state_file 6)" | grep -q -e '"selected":-1' -e '"step":0' || fail "Return marks no cell"
  xdotool key ctrl+Up Home g
  save 7
  [ "$(grep selected "$(state_file 6)")" != "$(grep selected "$(state_file 7)")" ] || fail "Ctrl+Up marks the same cell"
  quit
}

picks_with_the_mouse() {
  open_window
  # The window has no frame without a window manager, so its middle is that of the pane.
  xdotool mousemove 240 260 click 1
  save 2
  has 2 '"ray":{"direction"'
  has 2 '"show":"visited"'
  xdotool mousemove 240 260 keydown shift click 1 keyup shift
  save 3
  ! tr -d ' \n' <"$(state_file 3)" | grep -q '"selected":-1' || fail "Shift and a click select nothing"
  has 3 '"why":-1'
  xdotool mousemove 240 260 keydown ctrl click 1 keyup ctrl
  save 4
  ! tr -d ' \n' <"$(state_file 4)" | grep -q '"why":-1' || fail "Ctrl and a click ask nothing"
  xdotool key m
  save 5
  has 5 '"why":-1'
  quit
}

slides_with_the_mouse() {
  open_window --pixel 25,38
  # The bar of steps is the highest thing at the bottom: see layout.cpp.
  xdotool mousemove 20 527 mousedown 1 mousemove 60 527 mousemove 20 527 mouseup 1
  save 2
  has 2 '"step":0'
  xdotool mousemove 240 200 mousedown 1 mousemove 280 220 mousemove 300 240 mouseup 1
  save 3
  cmp -s "$(state_file 2)" "$(state_file 3)" && fail "a drag in space does not turn it"
  has 3 '"step":0'
  quit
}

takes_a_screenshot() {
  open_window --pixel 25,38
  xdotool key F12
  wait_until "a picture" test -s out/view/mirrors_bvh4.png
  is_png out/view/mirrors_bvh4.png || fail "the screenshot is no picture"
  xdotool key h F12
  wait_until "a second picture" test -s out/view/mirrors_bvh4_2.png
  ! cmp -s out/view/mirrors_bvh4.png out/view/mirrors_bvh4_2.png || fail "H shows no sheet"
  # Where it cannot be written, the window says so and stays.
  mv out not_out
  : >out
  xdotool key F12
  wait_until "a sentence about the picture" grep -q "cannot be written" stderr
  quit
}

"$2"
