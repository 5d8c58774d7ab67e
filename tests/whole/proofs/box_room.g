#: at least 1 e t: computed exit from a box, with room, beyond the computed entry
# A ray that touches a box at t alone: as this is at least 0, the test with room misses no box.

@rnd = float<24, ne>;
four_last_places = {shaders/structure/bvh/box_padded.glsl four_last_places};
abs_span_exit = span_exit; # t is above 0, and the exit with it
room rnd= {shaders/structure/bvh/box_padded.glsl meets_box room};
exit rnd= {shaders/structure/bvh/box_padded.glsl meets_box exit};
true_room = span_exit * four_last_places;

{
  t in [1b-100, 1b100] /\
  |entry -/ t| <= {box} /\
  |span_exit -/ t| <= {box}
  -> (exit - entry) / t in ?
}

(exit - entry) / t ->
  (exit - (span_exit + room)) / t + (room - true_room) / t + (span_exit / t * four_last_places) +
  (span_exit - t) / t - (entry - t) / t { t <> 0 };
(span_exit + room) / t ->
  (room - true_room) / t + (span_exit / t * four_last_places) + span_exit / t { t <> 0 };
true_room / t -> span_exit / t * four_last_places { t <> 0 };
span_exit / t -> 1 + (span_exit - t) / t { t <> 0 };
