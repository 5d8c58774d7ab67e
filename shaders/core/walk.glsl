// How far a walk through a structure has come. A launch need not finish it: the next one takes it
// up from here.
struct Walk {
    Hit nearest; // of the triangles tested so far
    ivec3 place; // where it goes on; what the numbers mean is the structure's own affair
    bool ended;
};
