// Pictures on surfaces. Corner c of triangle i has its place (u, v) in texel 3i + c; the lower left
// corner of a picture is (0, 0). A picture is four integers: its first texel, width, height and
// number of levels. Its levels lie one behind the other, each half as wide and half as high as the
// last (rounded down, at least 1), the top row first. A material has the number of its picture, or
// -1.
uniform samplerBuffer triangle_coordinates;
uniform samplerBuffer picture_texels;
uniform isamplerBuffer pictures;
uniform isamplerBuffer material_pictures;

const int no_picture = -1;

struct Picture {
    int first;
    int width;
    int height;
    int levels;
};

Picture picture_of(int number) {
    ivec4 texel = texelFetch(pictures, number);
    Picture picture;
    picture.first = texel.x;
    picture.width = texel.y;
    picture.height = texel.z;
    picture.levels = texel.w;
    return picture;
}

real3 triangle_coordinate(int triangle, int corner) {
    return real3(texelFetch(triangle_coordinates, 3 * triangle + corner));
}
