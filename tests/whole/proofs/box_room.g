#: at least -3 e t: computed exit from a box, with room, beyond the computed entry
# A ray that touches a box at t alone. Were this at least 0, the test with room would miss no box.

@rnd = float<24, ne>;
two_last_places = {shaders/structure/bvh/box_padded.glsl two_last_places};
room rnd= {shaders/structure/bvh/box_padded.glsl meets_box room};
exit rnd= {shaders/structure/bvh/box_padded.glsl meets_box exit};

{
  t in [1, 1] /\
  |entry -/ t| <= {box} /\
  |span_exit -/ t| <= {box}
  -> exit - entry in ?
}
