#include "reference/embree/embree.h"

#include "basics/error.h"
#include "reference/embree/there/embree_calls.h"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace raysteps {

namespace {

constexpr std::size_t rays_per_part = 1024; // that a thread takes at once: a multiple of a packet

RTCRay embree_ray(const Ray& ray) {
    RTCRay query{};
    query.org_x = ray.origin.x;
    query.org_y = ray.origin.y;
    query.org_z = ray.origin.z;
    query.dir_x = ray.direction.x;
    query.dir_y = ray.direction.y;
    query.dir_z = ray.direction.z;
    query.tnear = ray.t_min;
    query.tfar = ray.t_max;
    query.mask = ~0u;
    return query;
}

RTCRay8 embree_packet(std::span<const Ray> rays) {
    RTCRay8 packet{};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        packet.org_x[i] = rays[i].origin.x;
        packet.org_y[i] = rays[i].origin.y;
        packet.org_z[i] = rays[i].origin.z;
        packet.dir_x[i] = rays[i].direction.x;
        packet.dir_y[i] = rays[i].direction.y;
        packet.dir_z[i] = rays[i].direction.z;
        packet.tnear[i] = rays[i].t_min;
        packet.tfar[i] = rays[i].t_max;
        packet.mask[i] = ~0u;
    }
    return packet;
}

Valid first_rays(std::size_t count) {
    Valid valid;
    std::fill_n(valid.rays.begin(), count, -1);
    return valid;
}

Hit hit_of(const Ray& ray, unsigned geometry, unsigned triangle, const Hit& found) {
    if (geometry == RTC_INVALID_GEOMETRY_ID) {
        return {ray.t_max, 0.0f, 0.0f, no_triangle};
    }
    return {found.t, found.u, found.v, static_cast<int>(triangle)};
}

Hit nearest_of_one(RTCScene scene, const Ray& ray) {
    RTCRayHit query{};
    query.ray = embree_ray(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    const RTCRayHit found = intersect(scene, query);
    return hit_of(ray, found.hit.geomID, found.hit.primID,
                  {found.ray.tfar, found.hit.u, found.hit.v, no_triangle});
}

using PacketHits = std::array<Hit, packet_size>;

PacketHits nearest_of_packet(RTCScene scene, std::span<const Ray> rays) {
    RTCRayHit8 query{};
    query.ray = embree_packet(rays);
    std::fill_n(query.hit.geomID, packet_size, RTC_INVALID_GEOMETRY_ID);
    const RTCRayHit8 found = intersect(scene, first_rays(rays.size()), query);
    PacketHits hits{};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i] = hit_of(rays[i], found.hit.geomID[i], found.hit.primID[i],
                         {found.ray.tfar[i], found.hit.u[i], found.hit.v[i], no_triangle});
    }
    return hits;
}

// A ray that hits comes back with its end at minus infinity.
std::uint8_t any_of_one(RTCScene scene, const Ray& ray) {
    return occlude(scene, embree_ray(ray)).tfar < ray.t_min ? 1 : 0;
}

using PacketAnswers = std::array<std::uint8_t, packet_size>;

PacketAnswers any_of_packet(RTCScene scene, std::span<const Ray> rays) {
    const RTCRay8 found = occlude(scene, first_rays(rays.size()), embree_packet(rays));
    PacketAnswers answers{};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        answers[i] = found.tfar[i] < rays[i].t_min ? 1 : 0;
    }
    return answers;
}

// The answers of all rays. A thread answers a part into memory of its own and copies it at once:
// threads that write into the same cache lines wait for each other.
template <class Answer, class One, class Packet>
std::vector<Answer> answers_of(std::span<const Ray> rays, EmbreeCall call, unsigned threads,
                               const One& one, const Packet& packet) {
    std::vector<Answer> answers(rays.size());
    in_parts(threads, rays.size(), rays_per_part, [&](std::size_t begin, std::size_t end) {
        alignas(64) std::array<Answer, rays_per_part> own;
        const std::span<const Ray> part = rays.subspan(begin, end - begin);
        if (call == EmbreeCall::one_by_one) {
            std::transform(part.begin(), part.end(), own.begin(), one);
        } else {
            for (std::size_t i = 0; i < part.size(); i += packet_size) {
                const std::size_t count = std::min(packet_size, part.size() - i);
                std::copy_n(packet(part.subspan(i, count)).begin(), count, own.begin() + i);
            }
        }
        std::copy_n(own.begin(), part.size(), answers.begin() + begin);
    });
    return answers;
}

void add_triangles(RTCDevice device, RTCScene scene, std::span<const glm::vec3> corners) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), corners.size()));
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), corners.size() / 3));
    if (vertices != nullptr && indices != nullptr) {
        std::copy(corners.begin(), corners.end(), vertices);
        std::iota(indices, indices + corners.size() / 3 * 3, 0u);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
    }
    rtcReleaseGeometry(geometry);
}

void check(RTCDevice device) {
    const RTCError error = rtcGetDeviceError(device);
    if (error != RTC_ERROR_NONE) {
        throw MachineError("Embree fails with its error " + std::to_string(error) +
                           (error == RTC_ERROR_OUT_OF_MEMORY
                                ? ": memory is short. Take a smaller scene."
                                : ". Leave it out with --embree off."));
    }
}

} // namespace

struct EmbreeScene::Inside {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = device == nullptr ? nullptr : rtcNewScene(device);
    double build_seconds = 0.0;

    Inside() = default;
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    ~Inside() {
        if (scene != nullptr) {
            rtcReleaseScene(scene);
        }
        if (device != nullptr) {
            rtcReleaseDevice(device);
        }
    }
};

std::string embree_name() {
    return std::string("Embree ") + RTC_VERSION_STRING;
}

EmbreeScene::EmbreeScene(std::span<const glm::vec3> corners, EmbreeMode mode)
    : inside_(std::make_unique<Inside>()) {
    if (inside_->scene == nullptr) {
        check(inside_->device);
        throw MachineError("Embree does not start. Leave it out with --embree off.");
    }
    rtcSetSceneFlags(inside_->scene,
                     mode == EmbreeMode::robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    const auto start = std::chrono::steady_clock::now();
    if (!corners.empty()) {
        add_triangles(inside_->device, inside_->scene, corners);
    }
    rtcCommitScene(inside_->scene);
    inside_->build_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    check(inside_->device);
}

EmbreeScene::~EmbreeScene() = default;
EmbreeScene::EmbreeScene(EmbreeScene&&) noexcept = default;
EmbreeScene& EmbreeScene::operator=(EmbreeScene&&) noexcept = default;

Hit EmbreeScene::nearest_hit(const Ray& ray) const {
    return nearest_of_one(inside_->scene, ray);
}

std::vector<Hit> EmbreeScene::nearest_hits(std::span<const Ray> rays, EmbreeCall call,
                                           unsigned threads) const {
    return answers_of<Hit>(
        rays, call, threads, [&](const Ray& ray) { return nearest_of_one(inside_->scene, ray); },
        [&](std::span<const Ray> packet) { return nearest_of_packet(inside_->scene, packet); });
}

std::vector<std::uint8_t> EmbreeScene::any_hits(std::span<const Ray> rays, EmbreeCall call,
                                                unsigned threads) const {
    return answers_of<std::uint8_t>(
        rays, call, threads, [&](const Ray& ray) { return any_of_one(inside_->scene, ray); },
        [&](std::span<const Ray> packet) { return any_of_packet(inside_->scene, packet); });
}

double EmbreeScene::build_seconds() const {
    return inside_->build_seconds;
}

} // namespace raysteps
