// In octant 0, the planes that come first are the lower ones of a box. A ray that descends along an
// axis comes to them last.

real3 bvh_first_planes(BoxRay ray, BvhNode node) {
    real3 planes = node.first_planes;
    planes.x = descends(ray, 0) ? node.last_planes.x : planes.x;
    planes.y = descends(ray, 1) ? node.last_planes.y : planes.y;
    planes.z = descends(ray, 2) ? node.last_planes.z : planes.z;
    return planes;
}

real3 bvh_last_planes(BoxRay ray, BvhNode node) {
    real3 planes = node.last_planes;
    planes.x = descends(ray, 0) ? node.first_planes.x : planes.x;
    planes.y = descends(ray, 1) ? node.first_planes.y : planes.y;
    planes.z = descends(ray, 2) ? node.first_planes.z : planes.z;
    return planes;
}

bool meets_bvh_node(BoxRay ray, BvhNode node, real t_max) {
    return meets_box(ray, bvh_first_planes(ray, node), bvh_last_planes(ray, node), t_max);
}
