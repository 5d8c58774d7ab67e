#include "scene/mtl_picture.h"

#include "scene/obj_findings.h"
#include "scene/obj_paths.h"

namespace raysteps {

MtlPicture find_picture(const std::string& name, const std::filesystem::path& mtl_path,
                        const std::filesystem::path& inside) {
    if (name.empty())
        return {};
    const auto path = path_inside(inside, folder_of(mtl_path), name);
    if (path)
        return {path->string(), ""};
    return {"", mtl_path.string() + ": The picture " + in_quotes(name) +
                    " is not in the folder of the model, so it is left out."};
}

} // namespace raysteps
