#include "scene/ply/ply_header.h"

#include "basics/error.h"
#include "basics/text.h"
#include "scene/obj/obj_file.h"

#include <array>
#include <optional>
#include <utility>

namespace raysteps {

namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names{
    {{"char", PlyType::int8},
     {"int8", PlyType::int8},
     {"uchar", PlyType::uint8},
     {"uint8", PlyType::uint8},
     {"short", PlyType::int16},
     {"int16", PlyType::int16},
     {"ushort", PlyType::uint16},
     {"uint16", PlyType::uint16},
     {"int", PlyType::int32},
     {"int32", PlyType::int32},
     {"uint", PlyType::uint32},
     {"uint32", PlyType::uint32},
     {"float", PlyType::float32},
     {"float32", PlyType::float32},
     {"double", PlyType::float64},
     {"float64", PlyType::float64}}};

class PlyHeaderReader {
public:
    PlyHeaderReader(std::string_view bytes, const std::filesystem::path& path)
        : bytes_(bytes), path_(path) {}

    PlyHeader read() {
        next_line();
        if (words_.size() != 1 || words_[0] != "ply") {
            fail("a PLY file begins with the line `ply`");
        }
        bool has_format = false;
        for (next_line(); words_.empty() || words_[0] != "end_header"; next_line()) {
            has_format = take_line() || has_format;
        }
        if (!has_format) {
            fail("the header names no format");
        }
        header_.length = place_;
        return std::move(header_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(place(path_, line_number_) + what + ". Check the export.");
    }

    void next_line() {
        const std::size_t end = bytes_.find('\n', place_);
        if (end == std::string_view::npos) {
            fail("the header has no end");
        }
        line_ = bytes_.substr(place_, end - place_);
        if (line_.ends_with('\r')) {
            line_.remove_suffix(1);
        }
        place_ = end + 1;
        ++line_number_;
        words_ = split_words(line_);
    }

    // Whether it was the format.
    bool take_line() {
        if (words_.empty() || words_[0] == "obj_info") {
            return false;
        }
        if (words_[0] == "comment") {
            if (words_.size() > 2 && words_[1] == "TextureFile") {
                header_.picture = after_first_word(after_first_word(line_));
            }
            return false;
        }
        if (words_[0] == "format" && words_.size() == 3) {
            take_format();
            return true;
        }
        if (words_[0] == "element" && words_.size() == 3) {
            const auto count = to_whole_number(words_[2]);
            if (!count || *count < 0) {
                fail("an element has no count");
            }
            header_.elements.push_back(
                {std::string(words_[1]), static_cast<std::uint64_t>(*count), {}});
            return false;
        }
        if (words_[0] == "property" && !header_.elements.empty()) {
            take_property();
            return false;
        }
        header_.skipped_line =
            header_.skipped_line == 0 ? static_cast<int>(line_number_) : header_.skipped_line;
        return false;
    }

    void take_format() {
        if (words_[1] == "ascii") {
            header_.format = PlyFormat::ascii;
        } else if (words_[1] == "binary_little_endian") {
            header_.format = PlyFormat::little_endian;
        } else if (words_[1] == "binary_big_endian") {
            header_.format = PlyFormat::big_endian;
        } else {
            fail("there is no PLY format " + in_quotes(words_[1]));
        }
    }

    void take_property() {
        PlyProperty property;
        if (words_.size() == 5 && words_[1] == "list") {
            property = {std::string(words_[4]), type_of(words_[3]), true, type_of(words_[2])};
        } else if (words_.size() == 3) {
            property = {std::string(words_[2]), type_of(words_[1]), false, PlyType::uint8};
        } else {
            fail("a property has a type and a name");
        }
        header_.elements.back().properties.push_back(std::move(property));
    }

    PlyType type_of(std::string_view word) const {
        for (const auto& [name, type] : type_names) {
            if (name == word) {
                return type;
            }
        }
        fail("PLY has no type " + in_quotes(word));
    }

    std::string_view bytes_;
    const std::filesystem::path& path_;
    PlyHeader header_;
    std::size_t place_ = 0;
    std::int64_t line_number_ = 0;
    std::string_view line_;
    std::vector<std::string_view> words_;
};

} // namespace

std::size_t size_of(PlyType type) {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

PlyHeader parse_ply_header(std::string_view bytes, const std::filesystem::path& path) {
    return PlyHeaderReader(bytes, path).read();
}

} // namespace raysteps
