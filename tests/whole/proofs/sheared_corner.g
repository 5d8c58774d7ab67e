#: at most 6 e M: sheared corner, x and y
# True floats, so an underflow of the shear is in it. Lengths are scaled by a power of two until M is in [1, 2], which
# leaves every rounding as it is.

@rnd = float<ieee_32, ne>;
corner_x = rnd(any_corner_x);
corner_y = rnd(any_corner_y);
corner_z = rnd(any_corner_z);
ray_origin_x = rnd(any_origin_x);
ray_origin_y = rnd(any_origin_y);
ray_origin_z = rnd(any_origin_z);
direction_x = rnd(any_direction_x);
direction_y = rnd(any_direction_y);
direction_z = rnd(any_direction_z);

ray_shear_x rnd= {shaders/triangle/watertight/shear.glsl prepare_ray shear_x};
ray_shear_y rnd= {shaders/triangle/watertight/shear.glsl prepare_ray shear_y};
p_x rnd= {shaders/triangle/watertight/shear.glsl sheared p.x};
p_y rnd= {shaders/triangle/watertight/shear.glsl sheared p.y};
p_z rnd= {shaders/triangle/watertight/shear.glsl sheared p.z};
x rnd= {shaders/triangle/watertight/shear.glsl sheared x};
y rnd= {shaders/triangle/watertight/shear.glsl sheared y};

true_x = (corner_x - ray_origin_x) - (direction_x / direction_z) * (corner_z - ray_origin_z);
true_y = (corner_y - ray_origin_y) - (direction_y / direction_z) * (corner_z - ray_origin_z);

{
  M in [1, 2] /\
  |(corner_x - ray_origin_x) / M| <= 1 /\
  |(corner_y - ray_origin_y) / M| <= 1 /\
  |(corner_z - ray_origin_z) / M| <= 1 /\
  |direction_x / direction_z| <= 1 /\ # z is the axis where the direction is longest
  |direction_y / direction_z| <= 1
  -> (x - true_x) / M in ? /\ (y - true_y) / M in ?
}

(x - true_x) / M, (y - true_y) / M $ M in 64;
