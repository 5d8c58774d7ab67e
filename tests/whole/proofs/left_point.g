#: at most 13 e L: origin that leaves a surface, each coordinate
# In units of L, the largest coordinate of the corners. A mean of corners is no larger than the largest; v may be over 1 - u
# by a rounding.

@rnd = float<24, ne>;
rounding_unit = {shaders/light/leave_surface.glsl rounding_unit};
largest = 1;
leaving_distance rnd= {shaders/light/leave_surface.glsl leaving_distance return};
point rnd= {shaders/light/surface.glsl surface_at point};
origin rnd= {shaders/light/surface.glsl surface_at origin};
true_point = a + hit_u * (b - a) + hit_v * (c - a);

{
  |a| <= 1 /\
  |b| <= 1 /\
  |c| <= 1 /\
  hit_u in [0, 1] /\
  hit_v in [0, 1] /\
  |a + hit_u * (b - a)| <= 1 /\
  |true_point| <= 1.000001 /\
  |geometric| <= 1.000001
  -> origin - (true_point + leaving_distance * geometric) in ?
}
