#include "manifests.h"

#include "source_tree.h"

#include <algorithm>
#include <regex>
#include <set>

namespace fs = std::filesystem;

namespace {

struct Birth {
    std::string entry; // a file or folder
    std::string chapter;
};

std::vector<Birth> read_manifests(const fs::path& root) {
    std::vector<Birth> births;
    for (const std::string& chapter : list_targets(root, "chapters")) {
        const fs::path manifest = root / "chapters" / chapter / "CMakeLists.txt";
        for (const std::string& entry : words_of_call(manifest, "add_chapter", "BORN")) {
            births.push_back({entry, chapter});
        }
        births.push_back({"chapters/" + chapter, chapter});
    }
    // The visualizer looks at all chapters, and comes after them.
    for (const std::string& entry :
         words_of_call(root / "visualizer" / "CMakeLists.txt", "add_visualizer", "BORN")) {
        births.push_back({entry, "visualizer"});
    }
    return births;
}

std::string manifest_of(const std::string& chapter) {
    return (chapter == "visualizer" ? "" : "chapters/") + chapter + "/CMakeLists.txt";
}

bool covers(const std::string& entry, const std::string& file) {
    return file == entry || file.starts_with(entry + "/");
}

// The chapters that name the longest entry over the file: one, where all is well.
std::set<std::string> birth_chapters(const std::vector<Birth>& births, const std::string& file) {
    std::size_t longest = 0;
    std::set<std::string> chapters;
    for (const Birth& birth : births) {
        if (!covers(birth.entry, file) || birth.entry.size() < longest) {
            continue;
        }
        if (birth.entry.size() > longest) {
            chapters.clear();
            longest = birth.entry.size();
        }
        chapters.insert(birth.chapter);
    }
    return chapters;
}

std::string join_words(const std::set<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : " and ") + word;
    }
    return text;
}

// A folder of chapters/ without a number is a program beside the lessons: it comes before and after
// all of them.
bool is_beside_the_lessons(const std::string& chapter) {
    return chapter != "visualizer" && (chapter[0] < '0' || chapter[0] > '9');
}

// The lists that each chapter with new parts or modules adds a line to.
bool is_spine(const std::string& file) {
    return file.ends_with("/CMakeLists.txt") || file == "common/mirror/parts.inc";
}

// The files of common/ and shaders/ that stand in quotes on the line, as in "scene/scene.h".
std::vector<std::string> named_files(const fs::path& root, const std::string& line) {
    static const std::regex quoted(R"re("([^"\s]+)")re");
    std::vector<std::string> files;
    for (std::sregex_iterator match(line.begin(), line.end(), quoted), end; match != end; ++match) {
        for (const std::string& folder : {std::string("common/"), std::string("shaders/")}) {
            const std::string file = folder + (*match)[1].str();
            if (fs::is_regular_file(root / file)) {
                files.push_back(file);
            }
        }
    }
    return files;
}

} // namespace

std::vector<std::string> find_faults_of_manifests(const fs::path& root) {
    const std::vector<Birth> births = read_manifests(root);
    std::vector<std::string> faults;
    for (const Birth& birth : births) {
        if (!fs::exists(root / birth.entry)) {
            faults.push_back(manifest_of(birth.chapter) + ": BORN names " + birth.entry +
                             ", which does not exist.");
        }
    }
    for (const std::string& file : list_files(root, {"common", "shaders"})) {
        const std::set<std::string> chapters = birth_chapters(births, file);
        if (chapters.empty()) {
            faults.push_back(file + ": is born in no chapter.");
        } else if (chapters.size() > 1) {
            faults.push_back(file + ": is born in " + join_words(chapters) + ".");
        }
    }
    return faults;
}

std::vector<std::string> find_names_of_the_unborn(const fs::path& root) {
    const std::vector<Birth> births = read_manifests(root);
    std::vector<std::string> faults;
    for (const std::string& file : list_files(root, {"common", "shaders", "chapters"})) {
        const std::set<std::string> chapters = birth_chapters(births, file);
        if (is_spine(file) || chapters.size() != 1 || is_beside_the_lessons(*chapters.begin())) {
            continue;
        }
        int number = 0;
        for (const std::string& line : code_lines(root / file)) {
            ++number;
            for (const std::string& named : named_files(root, line)) {
                const std::set<std::string> later = birth_chapters(births, named);
                if (later.size() == 1 && !is_beside_the_lessons(*later.begin()) &&
                    *later.begin() > *chapters.begin()) {
                    faults.push_back(fault_at(file, number,
                                              "is born in " + *chapters.begin() + " and names " +
                                                  named + ", which is born in " + *later.begin() +
                                                  "."));
                }
            }
        }
    }
    return faults;
}
