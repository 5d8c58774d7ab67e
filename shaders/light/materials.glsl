// What the scene says of its surfaces. A triangle has three normals (texels 3i, 3i + 1, 3i + 2) and
// the number of its material; a material has three texels: diffuse; specular, with 1 in w where it
// is a mirror; emission.
uniform samplerBuffer triangle_normals;
uniform isamplerBuffer triangle_materials;
uniform samplerBuffer materials;

struct Material {
    real3 diffuse;
    real3 specular;
    real3 emission;
    bool mirror;
};

real3 triangle_normal(int triangle, int corner) {
    return real3(texelFetch(triangle_normals, 3 * triangle + corner));
}

Material triangle_material(int triangle) {
    int first = 3 * texelFetch(triangle_materials, triangle).x;
    vec4 specular_texel = texelFetch(materials, first + 1);
    Material material;
    material.diffuse = real3(texelFetch(materials, first));
    material.specular = real3(specular_texel);
    material.emission = real3(texelFetch(materials, first + 2));
    material.mirror = specular_texel.w > 0.0f;
    return material;
}
