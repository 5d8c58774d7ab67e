// The walk along the nodes as they lie: into a branch that the ray meets, past one that it does
// not. The part before says, in first_bvh_node, where the order begins, and in meets_bvh_node,
// whether the ray meets a node's box.
//
// place.x is the next node, place.y the next triangle of a leaf that the ray has met before it.
//
// A node is left out only where its box begins behind the best hit: strictly, since of equal hits
// the smallest triangle wins. So the walk needs no order of the nodes to be right, only to be fast.

Walk start_walk(Ray ray) {
    Walk walk;
    walk.nearest = miss(ray);
    walk.ended = is_empty(ray) || bvh_node_count == 0;
    walk.place = ivec3(first_bvh_node(box_ray(ray)), no_bvh_triangle, 0);
    return walk;
}

// While there are nodes, on to the next leaf, then through its triangles: rays that a processor
// runs side by side then wait for each other in two short loops, rather than at each node.
Walk go_on(Walk walk, Ray ray, real near_enough, int rounds) {
    BoxRay prepared_for_boxes = box_ray(ray);
    PreparedRay prepared = prepare_ray(ray);
    Hit nearest = walk.nearest;
    int node = walk.place.x;
    int triangle = walk.place.y;
    int left = rounds;
    while (left > 0 && (node >= 0 || triangle >= 0)) {
        while (left > 0 && node >= 0 && triangle < 0) {
            observe_visit(node);
            BvhNode here = bvh_node(node);
            bool met = meets_bvh_node(prepared_for_boxes, here, nearest.t);
            triangle = met ? max(here.link, no_bvh_triangle) : no_bvh_triangle;
            node = met && !is_bvh_leaf(here) ? node + 1 : here.skip;
            --left;
        }
        while (left > 0 && triangle >= 0) {
            BvhTriangle tested = bvh_triangle(triangle);
            observe_test(tested.number);
            Hit hit = intersect_triangle(prepared, tested.a, tested.b, tested.c, tested.number);
            triangle = tested.last ? no_bvh_triangle : triangle + 1;
            if (is_nearer(hit, nearest)) {
                nearest = hit;
                bool found = hit.t <= near_enough;
                node = found ? no_bvh_node : node;
                triangle = found ? no_bvh_triangle : triangle;
            }
            --left;
        }
    }
    walk.nearest = nearest;
    walk.place = ivec3(node, triangle, 0);
    walk.ended = node < 0 && triangle < 0;
    return walk;
}
