#include "scene/obj_findings.h"

namespace raysteps {

namespace {

constexpr std::size_t most_kinds = 50;
constexpr std::size_t most_lines = 5;
constexpr std::size_t most_characters = 40;

bool is_printable(char character) {
    return character >= ' ' && character <= '~';
}

std::string listed(const std::vector<std::int64_t>& lines) {
    std::string text;
    for (const std::int64_t line : lines)
        text += (text.empty() ? "" : ", ") + std::to_string(line);
    return text;
}

} // namespace

std::string place(const std::filesystem::path& path, std::int64_t line) {
    return path.string() + ":" + std::to_string(line) + ": ";
}

std::string in_quotes(std::string_view word) {
    std::string text = "\"";
    for (const char character : word.substr(0, most_characters))
        text += is_printable(character) ? character : '?';
    return text + (word.size() > most_characters ? "...\"" : "\"");
}

void Findings::note(const std::string& sentence, std::int64_t line) {
    const bool is_full = findings_.size() >= most_kinds && !index_of_sentence_.contains(sentence);
    const std::string& kind = is_full ? "There is more of other kinds" : sentence;
    const auto [entry, is_new] = index_of_sentence_.try_emplace(kind, findings_.size());
    if (is_new)
        findings_.push_back({kind, 0, {}});
    Finding& finding = findings_[entry->second];
    ++finding.count;
    if (finding.first_lines.size() < most_lines)
        finding.first_lines.push_back(line);
}

std::vector<std::string> Findings::sentences(const std::filesystem::path& path) const {
    std::vector<std::string> sentences;
    for (const Finding& finding : findings_) {
        std::string sentence = place(path, finding.first_lines.front()) + finding.sentence;
        if (finding.count > 1)
            sentence += ", " + std::to_string(finding.count) + " times (lines " +
                        listed(finding.first_lines) +
                        (finding.count > static_cast<std::int64_t>(most_lines) ? ", ...)" : ")");
        sentences.push_back(sentence + ".");
    }
    return sentences;
}

} // namespace raysteps
