#include "trial.h"

#include "basics/text.h"
#include "gpu/shaders.h"

#include <fmt/core.h>

#include <algorithm>

namespace raysteps {

namespace {

std::string with_commas(std::size_t number) {
    std::string text = std::to_string(number);
    for (auto i = static_cast<std::ptrdiff_t>(text.size()) - 3; i > 0; i -= 3) {
        text.insert(static_cast<std::size_t>(i), ",");
    }
    return text;
}

// Rows of methods that gave the same answer.
struct Group {
    std::vector<std::string> methods;
    TrialRow row;
};

bool is_same_answer(const TrialRow& a, const TrialRow& b) {
    return a.where == b.where && a.expected == b.expected && a.got == b.got &&
           a.verdict == b.verdict;
}

std::vector<Group> grouped(std::span<const TrialRow> rows) {
    std::vector<Group> groups;
    for (const TrialRow& row : rows) {
        const auto known = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
            return is_same_answer(group.row, row);
        });
        if (known == groups.end()) {
            groups.push_back({{row.method}, row});
        } else {
            known->methods.push_back(row.method);
        }
    }
    return groups;
}

// All structures have one name where they all gave the same answer.
std::vector<std::string> with_structures_named_once(std::vector<std::string> methods) {
    const std::vector<NamedPart> structures = list_parts("structure");
    const auto is_structure = [&](const std::string& method) {
        return std::any_of(structures.begin(), structures.end(),
                           [&](const NamedPart& part) { return part.name == method; });
    };
    const auto count = std::count_if(methods.begin(), methods.end(), is_structure);
    if (count + 1 == static_cast<std::ptrdiff_t>(structures.size())) { // without the loop
        std::erase_if(methods, is_structure);
        methods.push_back("all " + std::to_string(count) + " structures");
    }
    return methods;
}

// The names of the methods, where they have room for it, in lines of at most that width.
std::vector<std::string> lines_of(const std::vector<std::string>& methods, std::size_t width) {
    std::vector<std::string> lines{""};
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const std::string word = methods[i] + (i + 1 < methods.size() ? "," : "");
        if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width) {
            lines.emplace_back();
        }
        lines.back() += (lines.back().empty() ? "" : " ") + word;
    }
    return lines;
}

std::string painted(Verdict verdict, Colors colors) {
    if (colors == Colors::none) {
        return to_words(verdict);
    }
    const char* color = verdict == Verdict::pass   ? "\033[32m"
                        : verdict == Verdict::fail ? "\033[1;31m"
                                                   : "\033[33m";
    return color + to_words(verdict) + "\033[0m";
}

std::string group_lines(const Group& group, Colors colors) {
    const std::vector<std::string> lines = lines_of(with_structures_named_once(group.methods), 30);
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i > 0) {
            text += "  " + lines[i] + "\n";
            continue;
        }
        text += fmt::format("  {:<30} {:<3}  {:<24}  {:<27} ", lines[i], group.row.where,
                            group.row.expected, group.row.got) +
                painted(group.row.verdict, colors) + "\n";
    }
    return text;
}

} // namespace

std::string to_words(std::size_t wrong, std::size_t tried) {
    return with_commas(wrong) + " of " + with_commas(tried);
}

Verdict verdict_of(std::size_t wrong) {
    return wrong == 0 ? Verdict::pass : Verdict::fail;
}

TrialRow promised_row(const std::string& method, const std::string& where,
                      const std::string& expected, std::size_t wrong, std::size_t tried) {
    return {method, where, expected, to_words(wrong, tried) + " wrong", verdict_of(wrong),
            tried,  wrong};
}

TrialRow reported_row(const std::string& method, const std::string& where,
                      const std::string& expected, std::size_t wrong, std::size_t tried) {
    TrialRow row = promised_row(method, where, expected, wrong, tried);
    row.verdict = Verdict::reported;
    return row;
}

std::string to_words(Verdict verdict) {
    switch (verdict) {
    case Verdict::pass:
        return "pass";
    case Verdict::fail:
        return "FAIL";
    case Verdict::reported:
        break;
    }
    return "reported";
}

std::string to_table(const TrialResult& result, Colors colors) {
    std::string text = result.trial.name + "  " + result.trial.title + "\n";
    if (result.rows.empty()) {
        return text + "  not tried: it needs the GPU\n";
    }
    for (const Group& group : grouped(result.rows)) {
        text += group_lines(group, colors);
    }
    const bool some_go_wrong = std::any_of(result.rows.begin(), result.rows.end(),
                                           [](const TrialRow& row) { return row.wrong > 0; });
    if (some_go_wrong && !result.trial.remedy.empty()) {
        text += "  remedy: " + result.trial.remedy + "\n";
    }
    return text;
}

std::string to_csv(std::span<const TrialResult> results) {
    std::string text = "case,method,where,expected,got,verdict,tried,wrong\n";
    for (const TrialResult& result : results) {
        for (const TrialRow& row : result.rows) {
            text += result.trial.name + "," + csv_field(row.method) + "," + row.where + "," +
                    csv_field(row.expected) + "," + csv_field(row.got) + "," +
                    to_words(row.verdict) + "," + std::to_string(row.tried) + "," +
                    std::to_string(row.wrong) + "\n";
        }
    }
    return text;
}

std::size_t count_rows(std::span<const TrialResult> results, Verdict verdict) {
    std::size_t count = 0;
    for (const TrialResult& result : results) {
        count += static_cast<std::size_t>(
            std::count_if(result.rows.begin(), result.rows.end(),
                          [&](const TrialRow& row) { return row.verdict == verdict; }));
    }
    return count;
}

} // namespace raysteps
