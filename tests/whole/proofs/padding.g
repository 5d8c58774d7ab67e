#: at least 6 e M: what the padding has left
# Along one axis, from the origin, in lengths of M. The ray ascends. At t it has come to the plane, as the floats say,
# so the triangle's point lies at most so far before the plane. The plane where it leaves is the same seen from behind.

std_max_reach = 1;
padding = {common/structure/padding.cpp padding_for return};

{
  |way - point| <= {hit} /\ # of t along the axis, and of the point
  |way_to_plane - plane| <= {plane} /\
  |way_to_box - box_plane| <= {box} /\
  way - way_to_plane in [0, 2] /\
  way - way_to_box in [0, 2]
  -> padding + (point - plane) in ? /\ padding + (point - box_plane) in ?
}

point - plane -> (way_to_plane - plane) + (way - way_to_plane) - (way - point);
point - box_plane -> (way_to_box - box_plane) + (way - way_to_box) - (way - point);
