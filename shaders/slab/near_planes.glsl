// The planes of a box as the ray comes to them.

real3 near_planes(BoxRay ray, real3 lower, real3 upper) {
    return real3(descends(ray, 0) ? upper.x : lower.x, descends(ray, 1) ? upper.y : lower.y,
                 descends(ray, 2) ? upper.z : lower.z);
}
