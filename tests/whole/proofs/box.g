#: at most 3 e M: plane of a box, as a part of its distance

@rnd = float<24, ne>;
ray_inverse_x rnd= {shaders/structure/bvh/box_ray.glsl box_ray inverse};
enters rnd= {shaders/structure/bvh/box_ray.glsl span_in_box enters.x};
leaves rnd= {shaders/structure/bvh/box_ray.glsl span_in_box leaves.x};

# The boxes of bvh4.
enters_of_four rnd= {shaders/structure/bvh/bvh4_nodes.glsl bvh4_spans enters.x};
leaves_of_four rnd= {shaders/structure/bvh/bvh4_nodes.glsl bvh4_spans leaves.x};

{
  |ray_direction| in [1b-200, 1b200]
  -> enters -/ ((first_planes_x - ray_first_origin_x) * (1 / ray_direction)) in ? /\
     leaves -/ ((last_planes_x - ray_last_origin_x) * (1 / ray_direction)) in ? /\
     enters_of_four -/ ((first_planes_x - ray_first_origin_x) * (1 / ray_direction)) in ? /\
     leaves_of_four -/ ((last_planes_x - ray_last_origin_x) * (1 / ray_direction)) in ?
}
