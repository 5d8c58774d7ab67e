// Embree 3 or 4: adapter_embree MODE %t %r %h, where MODE is fast, robust, compact, fast8 or
// robust8
#include "suite_files.h"

#include RTCORE_HEADER

#include <algorithm>

namespace {

RTCSceneFlags flags_of(const std::string& mode) {
    return mode.rfind("robust", 0) == 0 ? RTC_SCENE_FLAG_ROBUST
           : mode == "compact"          ? RTC_SCENE_FLAG_COMPACT
                                        : RTC_SCENE_FLAG_NONE;
}

void intersect(RTCScene scene, int width, const int* valid, RTCRayHit8& eight, RTCRayHit& one) {
#if RTC_VERSION_MAJOR >= 4
    width == 8 ? rtcIntersect8(valid, scene, &eight) : rtcIntersect1(scene, &one);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    width == 8 ? rtcIntersect8(valid, scene, &context, &eight)
               : rtcIntersect1(scene, &context, &one);
#endif
}

} // namespace

int main(int, char** argv) {
    const std::string mode = argv[1];
    const auto triangles = suite::read<suite::Triangle>(argv[2]);
    const auto rays = suite::read<suite::AimedRay>(argv[3]);
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, flags_of(mode));
    RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    if (!triangles.empty()) {
        auto* points = static_cast<suite::Triangle*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 3 * triangles.size()));
        std::copy(triangles.begin(), triangles.end(), points);
        auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles.size()));
        for (unsigned i = 0; i < 3 * triangles.size(); ++i) {
            indices[i] = i;
        }
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(scene, mesh);
    }
    rtcCommitScene(scene);
    const int width = mode.back() == '8' ? 8 : 1; // packets of eight, or ray by ray
    std::vector<suite::Answer> answers(rays.size());
    for (std::size_t first = 0; first < rays.size(); first += static_cast<std::size_t>(width)) {
        RTCRayHit8 eight{};
        alignas(32) int valid[8]{};
        for (int i = 0; i < 8; ++i) {
            const suite::AimedRay& ray = rays[std::min(first + i, rays.size() - 1)];
            valid[i] = i < width && first + i < rays.size() ? -1 : 0;
            eight.ray.org_x[i] = ray.origin[0];
            eight.ray.org_y[i] = ray.origin[1];
            eight.ray.org_z[i] = ray.origin[2];
            eight.ray.dir_x[i] = ray.direction[0];
            eight.ray.dir_y[i] = ray.direction[1];
            eight.ray.dir_z[i] = ray.direction[2];
            eight.ray.tnear[i] = ray.t_min;
            eight.ray.tfar[i] = ray.t_max;
            eight.ray.mask[i] = ~0U;
            eight.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        RTCRayHit one = rtcGetRayHitFromRayHitN(reinterpret_cast<RTCRayHitN*>(&eight), 8, 0);
        intersect(scene, width, valid, eight, one);
        for (int i = 0; i < width; ++i) {
            if (width == 8) {
                one = rtcGetRayHitFromRayHitN(reinterpret_cast<RTCRayHitN*>(&eight), 8, i);
            }
            if (valid[i] != 0 && one.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
                answers[first + i] = {one.ray.tfar, one.hit.u, one.hit.v,
                                      static_cast<std::int32_t>(one.hit.primID)};
            }
        }
    }
    suite::write(argv[4], answers);
    rtcReleaseGeometry(mesh);
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
}
