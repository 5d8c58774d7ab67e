// Four rays at once through a bounding volume hierarchy with up to four children a node: each node
// and each triangle is fetched once for all of them. For rays that are neighbours and go much the
// same way; others would wait for each other. Source: Wald, Slusallek, Benthin and Wagner,
// "Interactive Rendering with Coherent Ray Tracing", 2001.
//
// Rays of one octant of directions go together, since the planes that come first are the same for
// them; the others wait, with a t_max that lies before every box. A child is met where any ray
// meets it, the nearest is the one that a ray enters first, and each triangle is tested by all:
// the nearest hit wins, so it does not matter that a ray meets more than it would alone.
//
// What is put off is one number: of a child, its place; of a node with several children to be seen,
// twice its first texel, and a bit for each of them. The boxes are then met once more, since hits
// may have come before them. A packet that runs out of stack or rounds has not ended: its rays are
// traced one by one (pass/trace/resume.frag).
#include "structure/bvh/box_ray.glsl"
#include "structure/bvh/bvh_leaf.glsl"
#include "structure/bvh/bvh4_nodes.glsl"

const int packet_steps = 3; // through nodes, before triangles are tested
const int no_packet_place = -1;
const int all_of_packet_node = 15; // a bit for each of its children

struct PacketWalk {
    Hit nearest[4];
    bool ended;
};

struct PacketStack {
    ivec4 upper; // the top comes first
    ivec4 middle;
    ivec4 lower;
    ivec4 lowest;
};

PacketStack push_packet_place(PacketStack stack, int place) {
    PacketStack pushed;
    pushed.lowest = ivec4(stack.lower.w, stack.lowest.x, stack.lowest.y, stack.lowest.z);
    pushed.lower = ivec4(stack.middle.w, stack.lower.x, stack.lower.y, stack.lower.z);
    pushed.middle = ivec4(stack.upper.w, stack.middle.x, stack.middle.y, stack.middle.z);
    pushed.upper = ivec4(place, stack.upper.x, stack.upper.y, stack.upper.z);
    return pushed;
}

PacketStack pop_packet_place(PacketStack stack) {
    PacketStack popped;
    popped.upper = ivec4(stack.upper.y, stack.upper.z, stack.upper.w, stack.middle.x);
    popped.middle = ivec4(stack.middle.y, stack.middle.z, stack.middle.w, stack.lower.x);
    popped.lower = ivec4(stack.lower.y, stack.lower.z, stack.lower.w, stack.lowest.x);
    popped.lowest = ivec4(stack.lowest.y, stack.lowest.z, stack.lowest.w, no_packet_place);
    return popped;
}

int octant_of(BoxRay ray) {
    return (descends(ray, 0) ? 1 : 0) + (descends(ray, 1) ? 2 : 0) + (descends(ray, 2) ? 4 : 0);
}

// The children that are met and still to be seen.
struct PacketChoice {
    int count;
    int place; // of the nearest
    int other; // of the other one, where there are two; of those left, where there are more
};

int place_in_packet(int link) {
    return link < 0 ? link : 2 * link + all_of_packet_node;
}

PacketChoice choose_packet_child(BoxRay rays[4], real4 limits, int octant, int place) {
    int node = place >> 1 & ~7;
    real4 entry[4];
    real4 exit[4];
    for (int i = 0; i < 4; ++i) {
        entry[i] = real4(rays[i].t_min);
        exit[i] = real4(limits[i]);
    }
    for (int axis = 0; axis < 3; ++axis) {
        int turned = octant >> axis & 1;
        real4 first_planes = bvh4_planes(node + 2 * axis + turned);
        real4 last_planes = bvh4_planes(node + 2 * axis + 1 - turned);
        for (int i = 0; i < 4; ++i) {
            precise real4 enters =
                (first_planes - rays[i].first_origin[axis]) * rays[i].inverse[axis];
            precise real4 leaves =
                (last_planes - rays[i].last_origin[axis]) * rays[i].inverse[axis];
            precise real4 later = mix(entry[i], enters, greaterThan(enters, entry[i]));
            precise real4 sooner = mix(exit[i], leaves, lessThan(leaves, exit[i]));
            entry[i] = later;
            exit[i] = sooner;
        }
    }
    ivec4 links = bvh4_links(node);
    PacketChoice choice;
    choice.count = 0;
    choice.place = no_packet_place;
    int nearest_child = 0;
    int left = 0;
    int link = no_bvh4_place;
    int other = no_bvh4_place;
    real least = real(farthest);
    for (int child = 0; child < 4; ++child) {
        //# exercise 10.3: a box for four rays
        bool met = false;
        for (int i = 0; i < 4; ++i) {
            met = met || entry[i][child] <= exit[i][child];
        }
        // Of rays that do not meet it too: this is for the order alone, and a plain minimum is
        // one instruction.
        precise real of_lower =
            entry[0][child] < entry[1][child] ? entry[0][child] : entry[1][child];
        precise real of_upper =
            entry[2][child] < entry[3][child] ? entry[2][child] : entry[3][child];
        precise real first_entry = of_lower < of_upper ? of_lower : of_upper;
        bool waits = met && links[child] != no_bvh4_place && (place >> child & 1) != 0;
        //# stub: real first_entry = entry[0][child];
        //# stub: bool waits = entry[0][child] <= exit[0][child] && links[child] != no_bvh4_place;
        //# end
        bool nearer = waits && (choice.count == 0 || first_entry < least);
        int behind = waits ? links[child] : other;
        other = nearer ? link : behind;
        link = nearer ? links[child] : link;
        nearest_child = nearer ? child : nearest_child;
        least = nearer ? first_entry : least;
        left = waits ? left | 1 << child : left;
        choice.count = waits ? choice.count + 1 : choice.count;
    }
    choice.place = place_in_packet(link);
    choice.other =
        choice.count == 2 ? place_in_packet(other) : 2 * node + (left & ~(1 << nearest_child));
    return choice;
}

PacketWalk walk_packet(Ray rays[4], real near_enough, int rounds) {
    BoxRay for_boxes[4];
    PreparedRay for_triangles[4];
    PacketWalk walk;
    ivec4 octants = ivec4(-1); // those of rays that wait
    for (int i = 0; i < 4; ++i) {
        for_boxes[i] = box_ray(rays[i]);
        for_triangles[i] = prepare_ray(rays[i]);
        walk.nearest[i] = miss(rays[i]);
        bool empty = is_empty(rays[i]) || bvh_node_count == 0;
        octants[i] = empty ? -1 : octant_of(for_boxes[i]);
    }
    bool overflown = false;
    int left = rounds;
    int octant = max(max(octants.x, octants.y), max(octants.z, octants.w));
    if (octant >= 0) {
        do {
            real4 limits;
            for (int i = 0; i < 4; ++i) {
                bool goes = octants[i] == octant;
                limits[i] = goes ? walk.nearest[i].t : -real(farthest);
                octants[i] = goes ? -1 : octants[i];
            }
            PacketStack stack;
            stack.upper = ivec4(no_packet_place);
            stack.middle = ivec4(no_packet_place);
            stack.lower = ivec4(no_packet_place);
            stack.lowest = ivec4(no_packet_place);
            int place = all_of_packet_node;
            do {
                int last_left = max(left - packet_steps, 0);
                if (left > last_left && place >= 0) {
                    do {
                        PacketChoice choice = choose_packet_child(for_boxes, limits, octant, place);
                        place = choice.place;
                        if (choice.count > 1) {
                            overflown = overflown || stack.lowest.w != no_packet_place;
                            stack = push_packet_place(stack, choice.other);
                        }
                        if (choice.count == 0) {
                            place = stack.upper.x;
                            stack = pop_packet_place(stack);
                        }
                        --left;
                    } while (left > last_left && place >= 0);
                }
                if (left > 0 && place < no_packet_place) {
                    int triangle = -2 - place;
                    do {
                        BvhTriangle tested = bvh_triangle(triangle);
                        triangle = tested.last ? no_bvh_triangle : triangle + 1;
                        for (int i = 0; i < 4; ++i) {
                            Hit hit = intersect_triangle(for_triangles[i], tested.a, tested.b,
                                                         tested.c, tested.number);
                            if (is_nearer(hit, walk.nearest[i]) && limits[i] >= hit.t &&
                                is_solid(hit)) {
                                walk.nearest[i] = hit;
                                limits[i] = hit.t <= near_enough ? -real(farthest) : hit.t;
                            }
                        }
                        --left;
                    } while (left > 0 && triangle >= 0);
                    bool answered =
                        max(max(limits.x, limits.y), max(limits.z, limits.w)) == -real(farthest);
                    place = triangle < 0 ? stack.upper.x : -2 - triangle;
                    place = answered ? no_packet_place : place;
                    if (triangle < 0) {
                        stack = pop_packet_place(stack);
                    }
                }
            } while (left > 0 && place != no_packet_place);
            overflown = overflown || place != no_packet_place;
            octant = max(max(octants.x, octants.y), max(octants.z, octants.w));
        } while (left > 0 && octant >= 0);
    }
    walk.ended = !overflown && octant < 0;
    return walk;
}
