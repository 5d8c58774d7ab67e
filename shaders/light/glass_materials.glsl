// What refraction needs of the materials: two texels each. The first is what is left of light after
// one unit of length (Tf), and the refractive index (Ni); the second has in x the part of the light
// that does not stop at the surface (0 where the material is not glass).
uniform samplerBuffer glass_texels;

struct Glass {
    real3 transmission;
    real index;
    real transparency;
};

Glass glass_of(int material) {
    vec4 first = texelFetch(glass_texels, 2 * material);
    Glass glass;
    glass.transmission = real3(first);
    glass.index = real(first.w);
    glass.transparency = real(texelFetch(glass_texels, 2 * material + 1).x);
    return glass;
}

int material_number(int triangle) {
    return texelFetch(triangle_materials, triangle).x;
}

bool is_glass(int triangle) {
    return glass_of(material_number(triangle)).transparency > real(0.0f);
}
