// The glass bodies that a ray is inside of, the innermost first: numbers of materials, plus 1; 0 is
// none. A ray remembers four of them, and forgets the outermost where bodies nest deeper.

int innermost_medium(uvec4 media) {
    return int(media.x) - 1;
}

uvec4 enter_medium(uvec4 media, int material) {
    return uvec4(uint(material + 1), media.x, media.y, media.z);
}

bool is_inside(uvec4 media, int material) {
    uint entry = uint(material + 1);
    return media.x == entry || media.y == entry || media.z == entry || media.w == entry;
}

// Without the innermost entry of that material.
uvec4 leave_medium(uvec4 media, int material) {
    //# exercise 9.3: leaving a body
    uint entry = uint(material + 1);
    if (media.x == entry) {
        return uvec4(media.y, media.z, media.w, 0u);
    }
    if (media.y == entry) {
        return uvec4(media.x, media.z, media.w, 0u);
    }
    if (media.z == entry) {
        return uvec4(media.x, media.y, media.w, 0u);
    }
    if (media.w == entry) {
        return uvec4(media.x, media.y, media.z, 0u);
    }
    return media;
    //# stub: return media;
    //# end
}
