#include "reference/embree/embree.h"

#include "basics/error.h"

namespace raysteps {

namespace {

[[noreturn]] void refuse() {
    throw MachineError("this program was built without Embree. Install Embree (the package "
                       "libembree-dev) and build again.");
}

} // namespace

struct EmbreeScene::Inside {};

std::string embree_name() {
    return "";
}

EmbreeScene::EmbreeScene(std::span<const glm::vec3>, EmbreeMode) {
    refuse();
}

EmbreeScene::~EmbreeScene() = default;
EmbreeScene::EmbreeScene(EmbreeScene&&) noexcept = default;
EmbreeScene& EmbreeScene::operator=(EmbreeScene&&) noexcept = default;

Hit EmbreeScene::nearest_hit(const Ray&) const {
    refuse();
}

std::vector<Hit> EmbreeScene::nearest_hits(std::span<const Ray>, EmbreeCall, unsigned) const {
    refuse();
}

std::vector<std::uint8_t> EmbreeScene::any_hits(std::span<const Ray>, EmbreeCall, unsigned) const {
    refuse();
}

double EmbreeScene::build_seconds() const {
    refuse();
}

} // namespace raysteps
