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

// A glossy highlight: the nearer the normal is to halfway between the eye and the lamp, the
// brighter. Source: Blinn, "Models of light reflection for computer synthesized pictures", 1977.

real3 highlight(Surface surface, real3 direction, real3 light_position, real3 light_color,
                Gloss gloss) {
    //# exercise 9.5: a highlight
    real3 to_light = unit(light_position - surface.origin);
    real3 halfway = to_light - unit(direction);
    real cosine = dot_product(surface.normal, halfway) / sqrt(dot_product(halfway, halfway));
    if (!(cosine > real(0.0f))) {
        return real3(real(0.0f));
    }
    return pow(min(cosine, real(1.0f)), gloss.exponent) * gloss.color * light_color;
    //# stub: return real3(real(0.0f));
    //# end
}
