#: at most 13 e L: origin that leaves a surface, each coordinate
# Lengths are scaled by a power of two until L, the largest coordinate of the corners, is in [1, 2]. A mean of corners is
# no larger than the largest; v may be over 1 - u by a rounding.

@rnd = float<24, ne>;
rounding_unit = {shaders/light/leave_surface.glsl rounding_unit};
largest = L;
leaving_distance rnd= {shaders/light/leave_surface.glsl leaving_distance return};
point rnd= {shaders/light/surface.glsl surface_at point};
origin rnd= {shaders/light/surface.glsl surface_at origin};
true_point = a + hit_u * (b - a) + hit_v * (c - a);

{
  L in [1, 2] /\
  |a / L| <= 1 /\
  |b / L| <= 1 /\
  |c / L| <= 1 /\
  hit_u in [0, 1] /\
  hit_v in [0, 1] /\
  |(a + hit_u * (b - a)) / L| <= 1 /\
  |true_point / L| <= 1.000001 /\
  |geometric| <= 1.000001
  -> (origin - (true_point + leaving_distance * geometric)) / L in ?
}

(origin - (true_point + leaving_distance * geometric)) / L $ L in 16;
