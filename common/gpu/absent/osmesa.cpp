#include "basics/error.h"
#include "gpu/context.h"

namespace raysteps {

std::unique_ptr<Context> make_osmesa_context() {
    throw MachineError("osmesa: this program was built without OSMesa. Install the package "
                       "libosmesa6-dev and build again, or try --context egl.");
}

} // namespace raysteps
