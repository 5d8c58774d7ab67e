#include "model_folder.h"

#include "scene/obj/load_obj.h"

#include "catch.h"

#include <sys/stat.h>

using namespace raysteps;

namespace {

void check_error(const std::string& name, const std::string& sentence) {
    CAPTURE(name);
    CHECK(error_of(corpus_file(name)) == corpus_file(name).string() + ":" + sentence);
}

} // namespace

TEST_CASE("a face that names a vertex that is not there is an error with its line", "[obj]") {
    check_error("index_out_of_range.obj",
                "5: face names vertex 99999, but the file has 3. Check the export.");
    check_error("index_too_negative.obj",
                "5: face names vertex -4, but only 3 stand above it. Check the export.");
    check_error("index_of_texture_coordinate_out_of_range.obj",
                "5: face names texture coordinate 2, but the file has 1. Check the export.");
    check_error("index_of_normal_out_of_range.obj",
                "5: face names normal 2, but the file has 1. Check the export.");
}

TEST_CASE("an index that is no index is an error with its line", "[obj]") {
    for (const char* name :
         {"index_beyond_32_bits.obj", "index_beyond_64_bits.obj", "index_zero.obj",
          "index_not_a_number.obj", "index_missing.obj", "index_with_four_parts.obj"}) {
        CAPTURE(name);
        CHECK_THAT(error_of(corpus_file(name)), contains_text(":4: face has the corner \""));
    }
    CHECK_THAT(error_of(corpus_file("index_beyond_32_bits.obj")), contains_text("\"4294967297\""));
}

TEST_CASE("a coordinate that is no usable number is an error with its line", "[obj]") {
    check_error("nan_vertex.obj",
                "4: \"nan\" is not a number between -1.8e18 and 1.8e18. Check the export.");
    check_error("inf_vertex.obj",
                "2: \"inf\" is not a number between -1.8e18 and 1.8e18. Check the export.");
    check_error("too_large_for_float.obj",
                "2: \"1e39\" is not a number between -1.8e18 and 1.8e18. Check the export.");
    check_error("too_large_to_square.obj",
                "2: \"-1.9e18\" is not a number between -1.8e18 and 1.8e18. Check the export.");
    check_error(
        "exponent_beyond_int.obj",
        "2: \"1e99999999999\" is not a number between -1.8e18 and 1.8e18. Check the export.");
    check_error("nan_texture_coordinate.obj",
                "4: \"nan\" is not a number between -1.8e18 and 1.8e18. Check the export.");
    check_error("hexadecimal_vertex.obj", "1: \"0x10\" is not a number. Check the export.");
    check_error("two_signs.obj", "1: \"+-1\" is not a number. Check the export.");
    check_error("two_coordinates.obj", "1: v has 2 numbers, but needs 3. Check the export.");
}

TEST_CASE("what the parser itself makes of a good number is checked once more", "[obj]") {
    CHECK_THAT(error_of_text("vt 0e999 0\nv 0 0 0\n"),
               contains_text(":1: a coordinate is not a number between -1.8e18 and 1.8e18. Check "
                             "the export."));
    CHECK(error_of(corpus_file("zero_with_huge_exponent.obj")).empty()); // of a vertex it is 0
}

TEST_CASE("a file that is no text is an error with its line", "[obj]") {
    check_error("zero_byte.obj",
                "4: holds a zero byte, so it is not plain text. Save it as UTF-8 text.");
    check_error("utf_16.obj",
                "1: holds a zero byte, so it is not plain text. Save it as UTF-8 text.");
}

TEST_CASE("folders and pipes and devices and missing files are errors", "[obj]") {
    ModelFolder folder("kinds_of_files");
    const std::filesystem::path pipe = folder.path() / "pipe.obj";
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    CHECK_THAT(error_of(folder.path()), contains_text("is a folder, not a file"));
    CHECK_THAT(error_of(pipe), contains_text("pipe.obj: is a device or a pipe"));
    CHECK_THAT(error_of("/dev/zero"), contains_text("/dev/zero: is a device or a pipe"));
    CHECK_THAT(error_of(folder.path() / "gone.obj"), contains_text("there is no such file"));
    CHECK_FALSE(error_of(std::string(5000, 'x')).empty());
    CHECK_FALSE(error_of("").empty());
}

TEST_CASE("a file over the limit is refused before it is read", "[obj]") {
    ModelFolder folder("size_limit");
    const std::filesystem::path path = folder.write("large.obj", "v 0 0 0\n");
    std::filesystem::resize_file(path, most_obj_bytes + 1); // sparse: it takes no room on the disk
    CHECK(error_of(path) == path.string() + ": has 4294967297 bytes, but the limit is 4294967296. "
                                            "Split it into smaller files.");
}

TEST_CASE("errors tell the line of the file although lines are joined", "[obj]") {
    CHECK_THAT(error_of_text("v 0 0 \\\n 0\n\n# comment \\\nv 1 \\\n x 2\n"),
               starts_with_text("model.obj:5: \"x\" is not a number."));
    CHECK_THAT(error_of_text("\r\r\nv x 0 0"), starts_with_text("model.obj:3: \"x\""));
}

TEST_CASE("what stands in a file cannot upset a sentence", "[obj]") {
    CHECK_THAT(error_of_text("v \x1b[31m\xff 0 0\n"), contains_text("\"?[31m?\""));
    CHECK_THAT(error_of_text("v " + std::string(100000, 'x') + " 0 0\n"),
               contains_text("\"" + std::string(40, 'x') + "...\""));
}
