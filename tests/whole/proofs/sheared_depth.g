#: at most 3 e M: sheared z, as a part of itself
# Rounded to 24 digits without a least exponent: then every error is a part of its number, whatever the scale.

@rnd = float<24, ne>;
ray_shear_z rnd= {shaders/triangle/watertight/shear.glsl prepare_ray shear_z};
p_z rnd= {shaders/triangle/watertight/shear.glsl sheared p.z};
z rnd= {shaders/triangle/watertight/shear.glsl sheared z};

{
  |direction_z| in [1b-200, 1b200]
  -> z -/ (1 / direction_z * (corner_z - ray_origin_z)) in ?
}
