#include "reference/embree/embree.h"

#include "basics/error.h"

namespace raysteps {

struct EmbreeBuilder::Inside {};

EmbreeBuilder::EmbreeBuilder(std::span<const Box>, const EmbreeTreeOptions&) {
    throw MachineError("this program was built without Embree. Install Embree (the package "
                       "libembree-dev) and build again.");
}

EmbreeBuilder::~EmbreeBuilder() = default;

void EmbreeBuilder::prepare() {}

EmbreeTree EmbreeBuilder::build() {
    return {};
}

EmbreeNodes EmbreeBuilder::nodes() const {
    return {};
}

} // namespace raysteps
