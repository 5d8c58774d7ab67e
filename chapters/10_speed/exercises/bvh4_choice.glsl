// Which child of a node comes next. The steps go through the nodes, five a node: nothing seen yet,
// and then what comes after each of its four children.

uvec4 checkpoint(Ray ray, int step) {
    int place = 8 * ((step - 1) / 5) + (step - 1) % 5;
    Bvh4Choice choice = choose_bvh4_child(box_ray(ray), place, ray.t_max);
    return uvec4(uint(choice.count), uint(choice.child), uint(choice.link), uint(choice.other));
}
