// The highlights of the materials: one texel each, the colour (Ks) and the exponent (Ns), which is
// 0 where the material has none.
uniform samplerBuffer gloss_texels;

struct Gloss {
    real3 color;
    real exponent;
};

Gloss gloss_of(int material) {
    vec4 texel = texelFetch(gloss_texels, material);
    Gloss gloss;
    gloss.color = real3(texel);
    gloss.exponent = real(texel.w);
    return gloss;
}
