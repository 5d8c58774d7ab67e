#: at most 2 e M: plane of a grid or a kd-tree, as a part of its distance

@rnd = float<24, ne>;
crossing rnd= {shaders/structure/grid/grid_cells.glsl crossing t};
distance rnd= {shaders/structure/kd_tree/kd_descent.glsl plane_distance t};

{
  |ray_direction| in [1b-200, 1b200]
  -> crossing -/ ((plane_of_grid - ray_origin) / ray_direction) in ? /\
     distance -/ ((plane - ray_origin) / ray_direction) in ?
}
