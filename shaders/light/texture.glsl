// Textures. Corner c of triangle i has its place (u, v) in texel 3i + c; the lower left
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

// The colour of a picture where a ray meets a surface, filtered over what the pixel sees there.

int level_size(int size, int level) {
    return max(1, size >> level);
}

int first_texel(Picture picture, int level) {
    int first = picture.first;
    for (int i = 0; i < level; ++i) {
        first += level_size(picture.width, i) * level_size(picture.height, i);
    }
    return first;
}

// The texel in a column and a row from the top; the picture repeats in all directions.
real3 picture_texel(Picture picture, int level, int column, int row) {
    int width = level_size(picture.width, level);
    int height = level_size(picture.height, level);
    int x = column - width * int(floor(real(column) / real(width)));
    int y = row - height * int(floor(real(row) / real(height)));
    int place = min(max(y, 0), height - 1) * width + min(max(x, 0), width - 1);
    return real3(texelFetch(picture_texels, first_texel(picture, level) + place));
}

// Between the four texels around a place, each the more the nearer it is. u and v are 0 to 1.
real3 between_texels(Picture picture, int level, real u, real v) {
    real x = u * real(level_size(picture.width, level)) - real(0.5f);
    real y = (real(1.0f) - v) * real(level_size(picture.height, level)) - real(0.5f);
    int column = int(floor(x));
    int row = int(floor(y));
    real right = x - floor(x);
    real below = y - floor(y);
    real3 upper = (real(1.0f) - right) * picture_texel(picture, level, column, row) +
                  right * picture_texel(picture, level, column + 1, row);
    real3 lower = (real(1.0f) - right) * picture_texel(picture, level, column, row + 1) +
                  right * picture_texel(picture, level, column + 1, row + 1);
    return (real(1.0f) - below) * upper + below * lower;
}

// Level 0 is the whole picture; where a pixel sees 2^n texels side by side, level n has one of
// them. Source: Williams, "Pyramidal parametrics", 1983.
real3 picture_color(Picture picture, real level, real u, real v) {
    real clamped = min(max(level, real(0.0f)), real(picture.levels - 1));
    int finer = int(floor(clamped));
    int coarser = min(finer + 1, picture.levels - 1);
    real part = clamped - floor(clamped);
    return (real(1.0f) - part) * between_texels(picture, finer, u, v) +
           part * between_texels(picture, coarser, u, v);
}

// How many texels the pixel's cone covers where it meets the triangle, as a power of two.
// Source: Akenine-Moeller and others, "Texture Level of Detail Strategies for Real-Time Ray
// Tracing", Ray Tracing Gems, 2019, chapter 20.
real level_at(Ray ray, Hit hit, Picture picture, real pixel_angle) {
    real3 a = triangle_corner(hit.triangle, 0);
    real3 across =
        cross_product(triangle_corner(hit.triangle, 1) - a, triangle_corner(hit.triangle, 2) - a);
    real3 place_a = triangle_coordinate(hit.triangle, 0);
    real3 place_b = triangle_coordinate(hit.triangle, 1) - place_a;
    real3 place_c = triangle_coordinate(hit.triangle, 2) - place_a;
    real texels = abs(place_b.x * place_c.y - place_b.y * place_c.x) * real(picture.width) *
                  real(picture.height);
    real area = sqrt(dot_product(across, across));
    real length_of_direction = sqrt(dot_product(ray.direction, ray.direction));
    real cosine = abs(dot_product(across, ray.direction)) / (area * length_of_direction);
    real width = pixel_angle * hit.t * length_of_direction / max(cosine, real(0.01f));
    bool has_sizes = texels > real(0.0f) && area > real(0.0f);
    return has_sizes ? real(0.5f) * log2(texels / area) + log2(width) : real(0.0f);
}

real3 picture_at(Ray ray, Hit hit, Picture picture, real pixel_angle) {
    real weight_a = real(1.0f) - hit.u - hit.v;
    real3 place = weight_a * triangle_coordinate(hit.triangle, 0) +
                  hit.u * triangle_coordinate(hit.triangle, 1) +
                  hit.v * triangle_coordinate(hit.triangle, 2);
    return picture_color(picture, level_at(ray, hit, picture, pixel_angle),
                         place.x - floor(place.x), place.y - floor(place.y));
}
