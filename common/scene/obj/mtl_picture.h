#pragma once

#include <filesystem>
#include <string>

namespace raysteps {

// Where the picture that a material names stands, or a message why it is left out.
struct MtlPicture {
    std::string path;
    std::string message;
};

// The name is seen from the folder of the MTL file. A picture outside the folder `inside` is left
// out; one that is not there keeps its path, so that whoever opens it can say so.
MtlPicture find_picture(const std::string& name, const std::filesystem::path& mtl_path,
                        const std::filesystem::path& inside);

} // namespace raysteps
