#!/usr/bin/env bash
# Opens a real window on a display without a screen, moves mouse and keys, and looks at what is shown and saved.
# Usage: xvfb_test.sh SHOW_SKY SCENARIO, a function below.
set -euo pipefail

# A slow machine gets its time: every wait ends as soon as what it waits for is there.
most_seconds=60

fail() {
  echo "window test: $*" >&2
  cat "$folder"/stdout "$folder"/stderr >&2 2>/dev/null || true
  exit 1
}

need() {
  command -v "$1" >/dev/null || {
    echo "window test: $1 is missing. Install the package $2, or leave this test out with ctest -LE window." >&2
    exit 1
  }
}

# wait_until "WHAT IT WAITS FOR" COMMAND...
wait_until() {
  local what=$1 end=$((SECONDS + most_seconds))
  shift
  until "$@"; do
    [ $SECONDS -lt $end ] || fail "waited $most_seconds seconds in vain for $what"
    sleep 0.05
  done
}

# The same, and the program must not end before.
wait_running_until() {
  local what=$1 end=$((SECONDS + most_seconds))
  shift
  until "$@"; do
    kill -0 "$program" 2>/dev/null || fail "the program ended before $what"
    [ $SECONDS -lt $end ] || fail "waited $most_seconds seconds in vain for $what"
    sleep 0.05
  done
}

open_display() {
  # A number of its own: a server that ends removes the socket of one that has just taken the same number. Its screen is
  # a file that can be read at any time.
  Xvfb ":$((100 + $$ % 50000))" -displayfd 3 -noreset -screen 0 800x600x24 -nolisten tcp -nocursor -fbdir "$folder" \
    3>"$folder/display" 2>"$folder/xvfb" &
  display_server=$!
  wait_until "a display" test -s "$folder/display"
  DISPLAY=:$(cat "$folder/display")
  export DISPLAY
}

close_all() {
  for process in ${program:-} ${display_server:-}; do
    kill "$process" 2>/dev/null || true
    wait "$process" 2>/dev/null || true
  done
  rm -rf "$folder"
}

has_window() {
  window=$(xdotool search --onlyvisible --name '^Raysteps: sky' 2>/dev/null | head -n 1)
  [ -n "$window" ]
}

# The title tells size and time of the last full picture.
shows_size() { xdotool getwindowname "$window" 2>/dev/null | grep -q "sky, $1 x $2, [0-9]* ms"; }

# start_program [MODE...]
start_program() {
  "$show_sky" "$folder/sky" "$@" >"$folder/stdout" 2>"$folder/stderr" &
  program=$!
  wait_running_until "a window" has_window
  wait_running_until "a full picture" shows_size 320 240
  xdotool mousemove 160 120
}

has_ended() { ! kill -0 "$program" 2>/dev/null; }

# end_with EXIT_CODE
end_with() {
  local code=0
  wait_until "the program's end" has_ended
  wait "$program" || code=$?
  [ "$code" -eq "$1" ] || fail "the exit code is $code instead of $1"
}

# save NUMBER: S, and waits for the picture.
save() {
  xdotool key s
  wait_running_until "screenshot $1" test -s "$folder/sky-$1.png"
}

# drag BUTTON X Y: from the window's middle and, without the button, back to it.
drag() { xdotool mousemove 160 120 mousedown "$1" mousemove 200 110 mousemove "$2" "$3" mouseup "$1" mousemove 160 120; }

same() { cmp -s "$folder/sky-$1.png" "$folder/sky-$2.png"; }
differ() { ! same "$1" "$2"; }

screen() { cksum <"$folder/Xvfb_screen0"; }
screen_is() { [ "$(screen)" = "$1" ]; }
screen_is_not() { [ "$(screen)" != "$1" ]; }

# big_endian FILE OFFSET: four bytes as a number.
big_endian() { od -An -tu4 --endian=big -j "$2" -N 4 "$1" | tr -d ' '; }

# Blue, green and red of the screen's pixel at X Y: the file has the format XWD, whose header gives
# its own length, the bytes of a row, and the number of the colors that follow it, 12 bytes each.
pixel() {
  local file=$folder/Xvfb_screen0
  local start=$(($(big_endian "$file" 0) + 12 * $(big_endian "$file" 76)))
  od -An -tu1 -j $((start + $(big_endian "$file" 48) * $2 + 4 * $1)) -N 3 "$file" | tr -s ' '
}
pixel_is() { [ "$(pixel "$1" "$2")" = " $3" ]; }
pixel_is_not() { ! pixel_is "$@"; }

shows_the_picture() {
  start_program
  xdotool mousemove 10 10
  # The ball, (1, 0.2, 0.05), in sRGB: 255 * (1.055 * 0.2 ^ (1 / 2.4) - 0.055) = 123.6, and 63.2.
  wait_running_until "the ball in the window's middle" pixel_is 160 120 "63 124 255"
  # Half way up at the left the direction is (-0.41, 0.00, -0.91), the color (0.29, 0.5, 0.04).
  local left
  left=$(pixel 0 120)
  set -- $left
  [ "$3" -lt "$2" ] && [ "$1" -lt "$3" ] || fail "the left of the window is $left"
  xdotool key q
  end_with 0
}

follows_the_mouse() {
  start_program
  save 1
  local first
  first=$(screen)
  drag 1 240 90 # orbit
  wait_running_until "a turned picture on the screen" screen_is_not "$first"
  save 2
  differ 1 2 || fail "a drag with the left button changes nothing"
  xdotool key r
  wait_running_until "the first picture on the screen again" screen_is "$first"
  save 3
  same 1 3 || fail "R does not bring back the first picture"
  drag 2 200 150 # pan
  save 4
  differ 1 4 || fail "a drag with the middle button changes nothing"
  xdotool key r
  drag 3 160 60 # zoom
  save 5
  differ 1 5 || fail "a drag with the right button changes nothing"
  xdotool key r click 4
  save 6
  differ 1 6 || fail "the wheel changes nothing"
  xdotool click 5 key c key r keydown ctrl
  drag 1 160 20 # roll
  xdotool keyup ctrl
  save 7
  differ 1 7 || fail "a drag with control changes nothing"
  xdotool key r
  save 8
  same 1 8 || fail "R does not bring back the first picture after everything"
  grep -q '^camera    --camera 0,0,5,0,0,0,40$' "$folder/stdout" || fail "C does not print the camera"
  for number in 1 2 3 4 5 6 7 8; do
    grep -qx "wrote     $folder/sky-$number.png" "$folder/stdout" || fail "a path is not printed"
  done
  xdotool key q
  end_with 0
}

resizes() {
  start_program
  for size in "300 200" "1 1" "611 333"; do
    xdotool windowsize "$window" $size
    wait_running_until "a picture of $size" shows_size $size
  done
  save 1
  local width height
  width=$(big_endian "$folder/sky-1.png" 16)
  height=$(big_endian "$folder/sky-1.png" 20)
  [ "$width $height" = "611 333" ] || fail "the screenshot is $width x $height instead of 611 x 333"
  wait_running_until "the ball in the middle" pixel_is 305 140 "63 124 255"
  xdotool key Escape
  end_with 0
}

shows_help() {
  start_program
  local without with
  without=$(screen)
  save 1
  xdotool key h
  wait_running_until "the help" screen_is_not "$without"
  with=$(screen)
  save 2
  same 1 2 || fail "the help is in the screenshot"
  screen_is "$with" || fail "a screenshot hides the help"
  xdotool key h
  wait_running_until "the picture without the help" screen_is "$without"
  xdotool key q
  end_with 0
}

says() { grep -qxh -- "$1" "$folder/stdout" "$folder/stderr"; }

changes_what_is_shown() {
  start_program live
  wait_running_until "a red ball" pixel_is 160 120 "63 124 255"
  xdotool key b
  wait_running_until "a green ball" pixel_is 160 120 "124 255 63"
  # The third word cannot be taken: the key goes on to the first.
  xdotool key b
  wait_running_until "a red ball again" pixel_is 160 120 "63 124 255"
  says "There is no such ball. Take another." || fail "it is not said what cannot be"
  xdotool key shift+b
  wait_running_until "the word before" pixel_is 160 120 "124 255 63"
  : >"$folder/sky.bad"
  xdotool key F5
  wait_running_until "what is wrong with a shader" says "sky.glsl:12: syntax error"
  rm "$folder/sky.bad"
  xdotool key F5
  wait_running_until "the shaders" says "now       with the shaders as they are now"
  xdotool mousemove 100 80 click 1
  wait_running_until "the command of a pixel" says "view      show 100,80"
  save 1
  drag 1 240 90
  [ "$(grep -c '^view ' "$folder/stdout")" -eq 1 ] || fail "a drag is taken for a click"
  xdotool key q
  end_with 0
}

has_a_panel() {
  start_program live
  save 1
  xdotool key h mousemove 80 50 click 1 # the list of the balls
  wait_running_until "the panel" pixel_is_not 160 120 "63 124 255"
  xdotool mousemove 60 94 click 1 # its second word
  wait_running_until "another ball" says "now       ball green"
  xdotool mousemove 60 100 mousedown 1 mousemove 90 110 mouseup 1
  save 2
  xdotool key h
  wait_running_until "a green ball" pixel_is 160 120 "124 255 63"
  ! says "view .*" || fail "a click on the panel is taken for one on the picture"
  xdotool key q
  end_with 0
}

# count_frames SIZE: that were rendered so far.
count_frames() { grep -c "^frame $1\$" "$folder/stdout" || true; }
count_coarse_frames() { grep '^frame' "$folder/stdout" | grep -vc '^frame 320x240$' || true; }
more_frames_than() { [ "$(count_frames 320x240)" -gt "$1" ]; }
more_coarse_frames_than() { [ "$(count_coarse_frames)" -gt "$1" ]; }

stays_live_when_slow() {
  start_program slow # 1.5 seconds for a full picture
  local move coarse full
  xdotool mousedown 1
  for move in 1 2 3; do
    coarse=$(count_coarse_frames)
    xdotool mousemove $((160 + 10 * move)) 120
    wait_running_until "a coarse picture of move $move" more_coarse_frames_than "$coarse"
  done
  full=$(count_frames 320x240)
  xdotool mousemove 200 130 mouseup 1
  wait_running_until "a full picture after the drag" more_frames_than "$full"
  xdotool key q
  end_with 0
}

# The processor time that the program has taken, in ticks of 10 ms: user and system.
ticks() { awk '{ print $14 + $15 }' "/proc/$program/stat"; }

rests_when_idle() {
  start_program
  save 1
  local before used
  before=$(ticks)
  sleep 2 # not for something to happen: nothing may
  used=$(($(ticks) - before))
  [ "$used" -le 5 ] || fail "an idle window takes $used of 200 ticks of the processor"
  xdotool key q
  end_with 0
}

closes_during_a_drag() {
  start_program slow
  xdotool mousedown 1 mousemove 200 110 mousemove 210 100 key q mousemove 220 90
  end_with 0
}

ends_with_an_error() {
  start_program fails_when_moved
  xdotool mousedown 1 mousemove 200 110
  end_with 3
  [ "$(cat "$folder/stderr")" = "show_sky: The renderer fails on purpose. Leave the mouse alone." ] ||
    fail "the error is told in other words"
}

need Xvfb xvfb
need xdotool xdotool
show_sky=$1
folder=$(mktemp -d)
trap close_all EXIT
open_display
"$2"
