#include "scene/ply/load_ply.h"

#include "basics/error.h"
#include "basics/file.h"
#include "basics/text.h"
#include "scene/obj/load_obj.h"
#include "scene/obj/mtl.h"
#include "scene/ply/ply_header.h"
#include "scene/scaling.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <new>
#include <optional>

namespace raysteps {

namespace {

// The numbers behind the header, one after the other.
class PlyNumbers {
public:
    PlyNumbers(std::string_view bytes, PlyFormat format, const std::filesystem::path& path)
        : rest_(bytes), format_(format), path_(path) {}

    double next(PlyType type) { return format_ == PlyFormat::ascii ? word() : binary(type); }

    // Of that many numbers of a type, more than the bytes can hold is no answer to wait for.
    void expect(std::uint64_t count, std::size_t least_bytes) const {
        if (count > rest_.size() / std::max<std::size_t>(1, least_bytes) + 1) {
            fail("it ends too early");
        }
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(path_.string() + ": " + what + ". Check the export.");
    }

private:
    double word() {
        const std::size_t first = rest_.find_first_not_of(" \t\r\n");
        if (first == std::string_view::npos) {
            fail("it ends too early");
        }
        const std::size_t end = std::min(rest_.find_first_of(" \t\r\n", first), rest_.size());
        const std::string_view word = rest_.substr(first, end - first);
        rest_.remove_prefix(end);
        const std::optional<double> number = to_number(word);
        if (!number) {
            fail(in_quotes(word) + " is not a number");
        }
        return *number;
    }

    template <class Number>
    double read() {
        std::array<char, sizeof(Number)> bytes{};
        if (rest_.size() < bytes.size()) {
            fail("it ends too early");
        }
        std::copy_n(rest_.begin(), bytes.size(), bytes.begin());
        rest_.remove_prefix(bytes.size());
        if ((format_ == PlyFormat::big_endian) != (std::endian::native == std::endian::big)) {
            std::reverse(bytes.begin(), bytes.end());
        }
        return static_cast<double>(std::bit_cast<Number>(bytes));
    }

    double binary(PlyType type) {
        switch (type) {
        case PlyType::int8:
            return read<std::int8_t>();
        case PlyType::uint8:
            return read<std::uint8_t>();
        case PlyType::int16:
            return read<std::int16_t>();
        case PlyType::uint16:
            return read<std::uint16_t>();
        case PlyType::int32:
            return read<std::int32_t>();
        case PlyType::uint32:
            return read<std::uint32_t>();
        case PlyType::float32:
            return read<float>();
        case PlyType::float64:
            break;
        }
        return read<double>();
    }

    std::string_view rest_;
    PlyFormat format_;
    const std::filesystem::path& path_;
};

// What a property of a vertex is for.
enum class VertexRole { x, y, z, nx, ny, nz, u, v, red, green, blue, none };

constexpr std::size_t role_count = 11;

VertexRole role_of(std::string_view name) {
    static const std::map<std::string_view, VertexRole> roles{{"x", VertexRole::x},
                                                              {"y", VertexRole::y},
                                                              {"z", VertexRole::z},
                                                              {"nx", VertexRole::nx},
                                                              {"ny", VertexRole::ny},
                                                              {"nz", VertexRole::nz},
                                                              {"u", VertexRole::u},
                                                              {"s", VertexRole::u},
                                                              {"texture_u", VertexRole::u},
                                                              {"v", VertexRole::v},
                                                              {"t", VertexRole::v},
                                                              {"texture_v", VertexRole::v},
                                                              {"red", VertexRole::red},
                                                              {"green", VertexRole::green},
                                                              {"blue", VertexRole::blue},
                                                              {"diffuse_red", VertexRole::red},
                                                              {"diffuse_green", VertexRole::green},
                                                              {"diffuse_blue", VertexRole::blue}};
    const auto role = roles.find(name);
    return role == roles.end() ? VertexRole::none : role->second;
}

// What a colour's number means from 0 to 1.
double greatest_of(PlyType type) {
    switch (type) {
    case PlyType::uint8:
        return 255.0;
    case PlyType::uint16:
        return 65535.0;
    default:
        return 1.0;
    }
}

// The transfer function of sRGB (IEC 61966-2-1, 1999), backwards.
float to_linear(double value) {
    if (!(value > 0.0)) { // NaN as well
        return 0.0f;
    }
    const double clamped = std::min(value, 1.0);
    return static_cast<float>(clamped <= 0.04045 ? clamped / 12.92
                                                 : std::pow((clamped + 0.055) / 1.055, 2.4));
}

constexpr std::uint64_t most_reserved = 1 << 26; // of elements

class PlyReading {
public:
    PlyReading(std::string_view bytes, const std::filesystem::path& path)
        : header_(parse_ply_header(bytes, path)),
          numbers_(bytes.substr(header_.length), header_.format, path) {
        file_.path = path;
        file_.counts = FindingsCount::faces;
        file_.objects = {""};
    }

    ObjFile read(Origin origin) {
        if (header_.skipped_line > 0) {
            messages_.push_back(place(file_.path, header_.skipped_line) +
                                "PLY has no such line in its header, so it was skipped.");
        }
        for (const PlyElement& element : header_.elements) {
            numbers_.expect(element.count, least_bytes_of(element));
            // An array that grows needs room for three of itself.
            const std::size_t usual = std::min<std::uint64_t>(element.count, most_reserved);
            if (element.name == "vertex") {
                positions_.reserve(usual);
                read_vertices(element);
            } else if (element.name == "face" || element.name == "tristrips") {
                file_.faces.reserve(file_.faces.size() + usual);
                file_.corners.reserve(file_.corners.size() + 3 * usual);
                read_faces(element);
            } else {
                skip(element);
            }
        }
        check_indices();
        place_positions(origin);
        return std::move(file_);
    }

    const std::string& picture() const { return header_.picture; }
    const std::vector<std::string>& messages() const { return messages_; }

private:
    std::size_t least_bytes_of(const PlyElement& element) const {
        std::size_t bytes = 0;
        for (const PlyProperty& property : element.properties) {
            bytes += header_.format == PlyFormat::ascii ? 2
                     : property.is_list                 ? size_of(property.length_type)
                                                        : size_of(property.type);
        }
        return bytes;
    }

    void skip(const PlyElement& element) {
        if (element.count > 0) {
            messages_.push_back(file_.path.string() + ": The elements " + in_quotes(element.name) +
                                " are not shown: " + std::to_string(element.count) + ".");
        }
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& property : element.properties) {
                skip(property);
            }
        }
    }

    void skip(const PlyProperty& property) {
        const std::uint64_t length = property.is_list ? length_of(property) : 1;
        for (std::uint64_t i = 0; i < length; ++i) {
            numbers_.next(property.type);
        }
    }

    std::uint64_t length_of(const PlyProperty& property) {
        const double length = numbers_.next(property.length_type);
        if (!(length >= 0.0 && length <= 1e9) || length != std::floor(length)) {
            numbers_.fail("the length of a list is no whole number");
        }
        const auto count = static_cast<std::uint64_t>(length);
        numbers_.expect(count, header_.format == PlyFormat::ascii ? 2 : size_of(property.type));
        return count;
    }

    void tell_unused(const PlyElement& element, const std::string& name) {
        messages_.push_back(file_.path.string() + ": The property " + in_quotes(name) +
                            " of its elements " + in_quotes(element.name) +
                            " is not shown: " + std::to_string(element.count) + ".");
    }

    void read_vertices(const PlyElement& element) {
        std::array<bool, role_count> is_there{};
        for (const PlyProperty& property : element.properties) {
            const VertexRole role = property.is_list ? VertexRole::none : role_of(property.name);
            if (role != VertexRole::none) {
                is_there[static_cast<std::size_t>(role)] = true;
            } else if (element.count > 0) {
                tell_unused(element, property.name);
            }
        }
        const auto has = [&](VertexRole first, int count) {
            return std::all_of(is_there.begin() + static_cast<int>(first),
                               is_there.begin() + static_cast<int>(first) + count,
                               [](bool there) { return there; });
        };
        if (!has(VertexRole::x, 3)) {
            numbers_.fail("its vertices have no x, y and z");
        }
        has_normals_ = has(VertexRole::nx, 3);
        has_places_ = has(VertexRole::u, 2);
        const bool has_colors = has(VertexRole::red, 3);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            const std::array<double, role_count> vertex = next_vertex(element);
            const auto three = [&](VertexRole first) {
                const auto at = static_cast<std::size_t>(first);
                return glm::dvec3(vertex[at], vertex[at + 1], vertex[at + 2]);
            };
            add_position(three(VertexRole::x));
            if (has_normals_) {
                add_normal(three(VertexRole::nx));
            }
            if (has_places_) {
                const glm::dvec3 place = three(VertexRole::u);
                file_.texture_coordinates.emplace_back(coordinate(place.x), coordinate(place.y));
            }
            if (has_colors) {
                const glm::dvec3 color = three(VertexRole::red);
                file_.colors.emplace_back(to_linear(color.x), to_linear(color.y),
                                          to_linear(color.z));
            }
        }
    }

    std::array<double, role_count> next_vertex(const PlyElement& element) {
        std::array<double, role_count> vertex{};
        for (const PlyProperty& property : element.properties) {
            const VertexRole role = property.is_list ? VertexRole::none : role_of(property.name);
            if (role == VertexRole::none) {
                skip(property);
                continue;
            }
            const double number = numbers_.next(property.type);
            const bool is_color =
                role == VertexRole::red || role == VertexRole::green || role == VertexRole::blue;
            vertex[static_cast<std::size_t>(role)] =
                is_color ? number / greatest_of(property.type) : number;
        }
        return vertex;
    }

    double coordinate(double number) const {
        if (!(std::abs(number) <= greatest_coordinate)) {
            numbers_.fail("a coordinate of vertex " + std::to_string(positions_.size()) +
                          " (from 0) is not a number between -1.8e18 and 1.8e18");
        }
        return number;
    }

    void add_position(const glm::dvec3& position) {
        for (int axis = 0; axis < 3; ++axis) {
            coordinate(position[axis]);
        }
        positions_.push_back(position);
    }

    void add_normal(const glm::dvec3& normal) {
        const double length = glm::length(normal);
        const bool is_direction = length > 0.0 && std::isfinite(length);
        file_.normals.push_back(is_direction ? glm::vec3(normal / length) : glm::vec3(0.0f));
    }

    void read_faces(const PlyElement& element) {
        for (const PlyProperty& property : element.properties) {
            if (!is_face(property) && element.count > 0) {
                tell_unused(element, property.name);
            }
        }
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& property : element.properties) {
                if (is_face(property) && element.name == "tristrips") {
                    read_strips(property);
                } else if (is_face(property)) {
                    read_face(property);
                } else {
                    skip(property);
                }
            }
        }
    }

    static bool is_face(const PlyProperty& property) {
        return property.is_list &&
               (property.name == "vertex_indices" || property.name == "vertex_index");
    }

    void read_face(const PlyProperty& property) {
        ObjFace face;
        face.number = ++face_number_;
        face.line = face.number;
        face.first_corner = file_.corners.size();
        const std::uint64_t length = length_of(property);
        for (std::uint64_t i = 0; i < length; ++i) {
            const int index = index_of(numbers_.next(property.type), face.number);
            file_.corners.push_back({index, index, index});
        }
        face.corner_count = static_cast<int>(length);
        if (length < 3) {
            file_.corners.resize(face.first_corner);
            file_.findings.note("A face with fewer than three corners was dropped", face.number);
            return;
        }
        file_.faces.push_back(face);
    }

    // Each vertex from the third of a strip on makes a triangle with the two before it, turned
    // around every other time; -1 ends a strip.
    void read_strips(const PlyProperty& property) {
        std::vector<int> strip;
        for (std::uint64_t i = length_of(property); i > 0; --i) {
            const double number = numbers_.next(property.type);
            if (number == -1.0) {
                strip.clear();
                continue;
            }
            strip.push_back(index_of(number, face_number_ + 1));
            const std::size_t count = strip.size();
            if (count < 3) {
                continue;
            }
            const bool turned = count % 2 == 0;
            ObjFace face;
            face.number = ++face_number_;
            face.line = face.number;
            face.first_corner = file_.corners.size();
            face.corner_count = 3;
            for (const std::size_t at :
                 {count - 3, count - (turned ? 1 : 2), count - (turned ? 2 : 1)}) {
                file_.corners.push_back({strip[at], strip[at], strip[at]});
            }
            file_.faces.push_back(face);
        }
    }

    int index_of(double number, int face) const {
        if (!(number >= 0.0 && number <= std::numeric_limits<int>::max()) ||
            number != std::floor(number)) {
            numbers_.fail("face " + std::to_string(face) +
                          " names a vertex that is no whole number from 0 on");
        }
        return static_cast<int>(number);
    }

    // Vertices may stand behind the faces, so their number is known only now.
    void check_indices() {
        for (const ObjFace& face : file_.faces) {
            for (int i = 0; i < face.corner_count; ++i) {
                ObjCorner& corner = file_.corners[face.first_corner + static_cast<std::size_t>(i)];
                const auto index = static_cast<std::size_t>(corner.position);
                if (index >= positions_.size()) {
                    numbers_.fail("face " + std::to_string(face.number) + " names vertex " +
                                  std::to_string(index) + " (from 0), but there are " +
                                  std::to_string(positions_.size()));
                }
                const bool has_normal = has_normals_ && file_.normals[index] != glm::vec3(0.0f);
                corner.normal = has_normal ? corner.normal : not_given;
                corner.texture_coordinate = has_places_ ? corner.texture_coordinate : not_given;
            }
        }
    }

    void place_positions(Origin origin) {
        if (origin == Origin::near_model) {
            DoubleBox box;
            for (const ObjCorner& corner : file_.corners) {
                extend(box, positions_[static_cast<std::size_t>(corner.position)]);
            }
            file_.origin = offset_of(box);
        }
        file_.positions.reserve(positions_.size());
        for (const glm::dvec3& position : positions_) {
            file_.positions.emplace_back(position - file_.origin);
        }
        positions_ = {};
    }

    PlyHeader header_;
    PlyNumbers numbers_;
    ObjFile file_;
    std::vector<glm::dvec3> positions_;
    std::vector<std::string> messages_;
    bool has_normals_ = false;
    bool has_places_ = false;
    int face_number_ = 0;
};

// The whole model has one material, which shows its picture where it has one, else its colours.
Material material_of(const PlyReading& reading, const ObjFile& file,
                     std::vector<std::string>& messages) {
    Material material;
    if (!file.colors.empty() || !reading.picture().empty()) {
        material.diffuse = glm::vec3(1.0f);
    }
    const MtlTexture picture = find_texture(reading.picture(), file.path, folder_of(file.path));
    material.diffuse_map = picture.path;
    if (!picture.message.empty()) {
        messages.push_back(picture.message);
    }
    return material;
}

// What the file says, and its material.
struct PlyModel {
    ObjFile file;
    Material material;
    std::vector<std::string> messages;
};

PlyModel read_model(std::string_view bytes, const std::filesystem::path& path, Origin origin) {
    PlyReading reading(bytes, path);
    PlyModel model{reading.read(origin), {}, reading.messages()};
    const std::vector<std::string> found =
        model.file.findings.sentences(path, FindingsCount::faces);
    model.messages.insert(model.messages.end(), found.begin(), found.end());
    model.material = material_of(reading, model.file, model.messages);
    model.file.material_names = {model.material.name};
    for (ObjFace& face : model.file.faces) {
        face.material_name = 0;
    }
    return model;
}

Scene scene_of(PlyModel model) {
    Scene scene = make_scene(std::move(model.file), {model.material});
    model.messages.insert(model.messages.end(), scene.messages.begin(), scene.messages.end());
    scene.messages = std::move(model.messages);
    return scene;
}

template <class Step>
Scene guarded(const std::filesystem::path& path, const Step& step) {
    try {
        return step();
    } catch (const std::bad_alloc&) {
        throw MachineError(path.string() + ": is too large for the memory of this machine. Close "
                                           "other programs, or load a smaller model.");
    }
}

} // namespace

Scene load_ply(const std::filesystem::path& path, Origin origin) {
    return guarded(path, [&] { // and the bytes are gone before there is a scene
        return scene_of(read_model(read_file(path, most_obj_bytes), path, origin));
    });
}

Scene parse_ply(std::string_view bytes, const std::filesystem::path& path, Origin origin) {
    return guarded(path, [&] { return scene_of(read_model(bytes, path, origin)); });
}

} // namespace raysteps
