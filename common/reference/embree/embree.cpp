#include "reference/embree/embree.h"

#include "basics/error.h"

namespace raysteps {

EmbreePart parse_embree(const std::string& text) {
    const bool is_there = !embree_name().empty();
    if (text == "off" || (text == "auto" && !is_there)) {
        return EmbreePart::none;
    }
    if (text != "auto" && text != "robust" && text != "fast") {
        throw InputError("--embree " + text +
                         ": Embree takes part in one of these ways: auto, robust, fast, off.");
    }
    if (!is_there) {
        throw MachineError("--embree " + text +
                           ": this program was built without Embree. Install Embree (the package "
                           "libembree-dev) and build again, or leave out --embree.");
    }
    return text == "fast" ? EmbreePart::fast : EmbreePart::robust;
}

} // namespace raysteps
