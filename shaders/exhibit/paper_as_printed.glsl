// The paper's listing, letter by letter but for the names of the types. No compiler takes it: see
// chapter 02, and the parts triangle/paper_*.glsl for what each repair does.
// Source: Wang and Wen, "Research of Acceleration Structures for GPU Based Ray Tracing", 2010,
// section 2.2.
#define float3 vec3
#define float4 vec4

struct PreparedRay {
    Ray ray;
};

PreparedRay prepare_ray(Ray ray) {
    PreparedRay prepared;
    prepared.ray = ray;
    return prepared;
}

float4 Intersects(float3 a, float3 b, float3 c, float3 o, float3 d, float3 minT, float mat_index,
                  float4 lasthit) {
    float3 e1 = b - a;
    float3 e2 = c - a;
    float3 p = cross(d, e2);
    float det = dot(p, e1);
    bool isHit = det > 0.000001f;

    float invdet = 1.0f / det;
    float3 tvec = o - a;
    float u = dot(p, tvec) * invdet;

    float3 a = cross(tvec, e1);
    float v = dot(q, d) * invdet;
    float t = dot(a, e2) * invdet;

    isHit = (u >= 0.0f) && (v >= 0.0f) && (u + v <= 1.0f) && (t < lasthit.z) && (t > minT);

    return isHit ? float4(u, v, t, mat_index) : lasthit;
}

Hit intersect_triangle(PreparedRay prepared, real3 a, real3 b, real3 c, int triangle) {
    float4 nothing = float4(0.0f, 0.0f, prepared.ray.t_max, -1.0f);
    float4 texel = Intersects(a, b, c, prepared.ray.origin, prepared.ray.direction, float3(0.0f),
                              float(triangle), nothing);
    Hit hit;
    hit.u = texel.x;
    hit.v = texel.y;
    hit.t = texel.z;
    hit.triangle = texel.w < 0.0f ? no_triangle : triangle;
    return hit;
}
