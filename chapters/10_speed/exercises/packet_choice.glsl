// Which child of a node comes next for four rays: the given one, and three beside it, a quarter
// along y, along z, and along both, each faster by a length of the direction than the one before.
// The steps go through the nodes, fifteen a node: a bit for each child that is still to be seen.

uvec4 checkpoint(Ray ray, int step) {
    BoxRay rays[4];
    for (int i = 0; i < 4; ++i) {
        Ray beside = ray;
        beside.origin.y = ray.origin.y + real(0.25f) * real(i & 1);
        beside.origin.z = ray.origin.z + real(0.25f) * real(i >> 1);
        beside.direction = ray.direction * real(i + 1);
        rays[i] = box_ray(beside);
    }
    int place = 16 * ((step - 1) / 15) + (step - 1) % 15 + 1;
    PacketChoice choice = choose_packet_child(rays, real4(ray.t_max), octant_of(rays[0]), place);
    return uvec4(uint(choice.count), uint(choice.place), uint(choice.other), 0u);
}
