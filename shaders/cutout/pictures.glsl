// Surfaces with holes: a hit counts only where the picture of its material is solid, by the texel
// that it falls on. Corner c of triangle i has its place (u, v) in texel 3i + c; the lower left
// corner of a picture is (0, 0), and it repeats in all directions. A picture is two integers beside
// its size: the first of its words of 32 texels, the top row first, and nothing. A material has the
// number of its picture, or -1.
uniform samplerBuffer cutout_coordinates;
uniform isamplerBuffer cutout_materials; // of the triangles
uniform isamplerBuffer material_cutouts;
uniform isamplerBuffer cutouts;
uniform isamplerBuffer cutout_words;

real3 cutout_coordinate(int triangle, int corner) {
    return real3(texelFetch(cutout_coordinates, 3 * triangle + corner));
}

// The texel of a row of that size, which begins at 0 and ends at 1.
int cutout_texel(real place, int size) {
    return min(int((place - floor(place)) * real(size)), size - 1);
}

bool is_solid(Hit hit) {
    int number = texelFetch(material_cutouts, texelFetch(cutout_materials, hit.triangle).x).x;
    if (number < 0) {
        return true;
    }
    ivec4 picture = texelFetch(cutouts, number);
    real weight_a = real(1.0f) - hit.u - hit.v;
    real3 place = weight_a * cutout_coordinate(hit.triangle, 0) +
                  hit.u * cutout_coordinate(hit.triangle, 1) +
                  hit.v * cutout_coordinate(hit.triangle, 2);
    int row = picture.z - 1 - cutout_texel(place.y, picture.z);
    int texel = row * picture.y + cutout_texel(place.x, picture.y);
    int word = texelFetch(cutout_words, picture.x + texel / 32).x;
    return ((word >> (texel & 31)) & 1) != 0;
}
