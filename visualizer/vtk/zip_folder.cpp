#include "zip_folder.h"

#include "basics/error.h"

#include <zip.h>

#include <algorithm>
#include <string>
#include <vector>

namespace raysteps::view {

namespace fs = std::filesystem;

void zip_folder(const fs::path& folder, const fs::path& archive) {
    const auto fail = [&] {
        throw InputError(archive.string() + ": the archive cannot be written. Name another place.");
    };
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    int error = 0;
    zip_t* const zip = zip_open(archive.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
    if (!zip) {
        fail();
    }
    for (const fs::path& file : files) {
        const std::string name = fs::relative(file, folder).generic_string();
        zip_source_t* const source = zip_source_file(zip, file.c_str(), 0, -1);
        if (!source || zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8) < 0) {
            zip_discard(zip);
            fail();
        }
    }
    if (zip_close(zip) != 0) {
        zip_discard(zip);
        fail();
    }
}

} // namespace raysteps::view
