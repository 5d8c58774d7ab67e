#: at most 11 e share: share of an area, as a part of itself
# a, b and c are the exact areas; the sign that they have in common is left out. That the computed ones are right to 4 e
# is proved by hand. One that is 0 is exact, and its terms fall away.

@rnd = float<24, ne>;
det rnd= {shaders/triangle/watertight/shear.glsl watertight_hit det};
share rnd= {shaders/triangle/watertight/shear.glsl watertight_hit share};
u rnd= {shaders/triangle/watertight/shear.glsl watertight_hit u};
v rnd= {shaders/triangle/watertight/shear.glsl watertight_hit v};

{
  |areas_x -/ a| <= 4b-24 /\
  |areas_y -/ b| <= 4b-24 /\
  |areas_z -/ c| <= 4b-24 /\
  a / (a + b) in [0, 1] /\ # one sign
  (a + b) / (a + b + c) in [0, 1] /\
  a + b in [1b-400, 1b400] /\
  a + b + c in [1b-400, 1b400]
  -> share -/ (a / (a + b + c)) in ? /\ u -/ (b / (a + b + c)) in ? /\ v -/ (c / (a + b + c)) in ?
}
