// How a walk finds its way through a tree with nothing but the parents of nodes: which child is the
// near one depends only on the ray's direction, so on the way up a walk knows what it has seen.
// Source: Hapala, Davidovic, Wald, Havran and Slusallek, "Efficient Stack-less BVH Traversal for
// Ray Tracing", 2011. There, three states say from where the walk came to a node; here, whether it
// still has to enter the node or has just left it, and the parent is asked for the rest.

// The first child lies behind its parent, and is the lower one along the axis of the two.
struct BvhChildren {
    int near;
    int far;
};

BvhChildren bvh_children(BoxRay ray, int place, int link) {
    int second = (-1 - link) >> 2;
    //# exercise 6.3: the near child
    bool turned = descends(ray, (-1 - link) & 3);
    BvhChildren children;
    children.near = turned ? second : place + 1;
    children.far = turned ? place + 1 : second;
    //# stub: BvhChildren children;
    //# stub: children.near = place + 1;
    //# stub: children.far = second;
    //# end
    return children;
}

struct BvhClimb {
    int node;  // no_bvh_node where the tree is done
    bool left; // else the node is to be entered
};

// From a node that is done: to its far sibling, else to the parent, which is done then too.
BvhClimb climb_bvh(BoxRay ray, int place) {
    int parent = bvh_parent(place);
    BvhClimb climb;
    climb.node = parent;
    climb.left = true;
    if (parent >= 0) {
        BvhChildren children = bvh_children(ray, parent, bvh_link(parent));
        //# exercise 6.4: up, and across to the far child
        bool was_near = place == children.near;
        climb.node = was_near ? children.far : parent;
        climb.left = !was_near;
        //# stub: climb.node = no_bvh_node;
        //# end
    }
    return climb;
}

// place.x is a node, place.y the next triangle of a leaf that was met before, place.z is 1 where
// the node is done and 0 where it is to be entered.
Walk start_walk(Ray ray) {
    Walk walk;
    walk.nearest = miss(ray);
    walk.ended = is_empty(ray) || bvh_node_count == 0;
    walk.place = ivec3(0, no_bvh_triangle, 0);
    return walk;
}
