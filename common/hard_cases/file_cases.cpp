#include "hard_cases/file_cases.h"

namespace raysteps {

namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string polygon(int sides) {
    std::string text;
    std::string face = "f";
    for (int i = 0; i < sides; ++i) { // on a parabola, so convex, in whole numbers
        text += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    return text + face + "\n";
}

} // namespace

std::vector<FileCase> file_cases() {
    const std::string no_number = "is not a number";
    return {
        {"F1", "nan as text", corners + "v nan 0 0\nf 1 2 3\n", -1, no_number},
        {"F2", "inf as text", "v 0 0 0\nv inf 0 0\nv 0 1 0\nf 1 2 3\n", -1, no_number},
        {"F3", "1e39, which is no float", "v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n", -1, no_number},
        {"F4", "a number whose square is no float", "v 0 0 0\nv -1.9e18 0 0\nv 0 1 0\nf 1 2 3\n",
         -1, no_number},
        {"F5", "an index that would wrap to the first vertex", corners + "f 4294967297 2 3\n", -1,
         "4294967297"},
        {"F6", "an index out of range", corners + "f 1 2 99999\n", -1, "names vertex 99999"},
        {"F7", "an index that counts back too far", corners + "f -1 -2 -4\n", -1,
         "names vertex -4"},
        {"F8", "an index of zero", corners + "f 0 1 2\n", -1, "\"0\""},
        {"F9", "statements in capitals", "V 0 0 0\nF 1 2 3\n", 0, "no statement \"V\""},
        {"F10", "a byte order mark", "\xef\xbb\xbf" + corners + "f 1 2 3\n", 1, ""},
        {"F11", "a concave quadrilateral, from each of its corners",
         "v 0 0 0\nv 2 -1 0\nv 1 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 3 4 1\nf 3 4 1 2\nf 4 1 2 3\n", 8,
         ""},
        {"F12", "a polygon of 256 corners", polygon(256), 254, ""},
        {"F13", "a polygon of 20,000 corners", polygon(20000), 19998, ""},
        {"F14", "faces without area", corners + "v 2 0 0\nf 1 2 4\nf 1 1 1\nf 1 2 2\nf 1 2 3\n", 1,
         "without area"},
        {"F15", "a library outside the model's folder",
         "mtllib ../../dev/zero\nmtllib /dev/zero\n" + corners + "f 1 2 3\n", 1, "/dev/zero"},
        {"F16", "no triangle at all", corners, 0, ""},
        {"F17", "no text at all: a zero byte", std::string("v 0 0 0\n\0", 9), -1, "zero byte"},
        {"F18", "no statement at all", "", 0, ""},
    };
}

std::string mtl_of_impossible_values() {
    return "newmtl impossible\nNi 0\nKd -1 2 nan\nKs inf 0 0\nNs inf\nd 7\nTf -1 0 0\nillum 99\n";
}

} // namespace raysteps
