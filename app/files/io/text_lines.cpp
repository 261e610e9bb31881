#include "app/files/io/text_lines.h"

#include <charconv>
#include <cstdlib>

#include "app/files/io/errors.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";
constexpr std::size_t kShown = 40;  // most letters of a word in a message
/// What begins a line of numbers in an OBJ; in names and comments a backslash is a letter.
constexpr std::array<std::string_view, 8> kNumbered{"v", "vt", "vn", "vp", "f", "fo", "l", "p"};

bool continues(std::string_view line) {
    std::string_view rest = line.substr(0, line.find('\\'));
    return line.ends_with('\\') && line.find('#') == std::string_view::npos &&
           std::ranges::find(kNumbered, takeWord(rest)) != kNumbered.end();
}

}  // namespace

std::string_view withoutMark(std::string_view text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
        throw InputError("it is a text in UTF-16, which is not read; export it as UTF-8");
    }
    return text.substr(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
}

TextLines::TextLines(std::string_view text) : rest_(withoutMark(text)) {}

std::string_view TextLines::take() {
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    const std::string_view line = withoutBlanks(rest_.substr(0, end));
    rest_.remove_prefix(end);
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : rest_.empty() ? 0 : 1);
    ++read_;
    return line;
}

bool TextLines::next() {
    if (rest_.empty()) {
        return false;
    }
    line_ = take();
    number_ = read_;
    if (!continues(line_)) {
        return true;
    }
    joined_ = line_;
    while (joined_.ends_with('\\') && !rest_.empty()) {
        joined_.back() = ' ';
        joined_ += take();
    }
    line_ = joined_;
    return true;
}

void namingLine(const TextLines& lines, const std::function<void()>& read) {
    try {
        read();
    } catch (const InputError& error) {
        throw InputError("line " + std::to_string(lines.number()) + ": " + error.what());
    }
}

std::string_view takeWord(std::string_view& text) {
    text = withoutBlanks(text);
    const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
    text.remove_prefix(word.size());
    return word;
}

std::string_view withoutBlanks(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    text.remove_suffix(text.size() - (text.find_last_not_of(kBlanks) + 1));
    return text;
}

double numberOf(std::string_view word) {
    double value = 0;
    const char* last = word.data() + word.size();
    const bool plus = word.starts_with('+') && !word.starts_with("+-");
    const auto [end, error] = std::from_chars(word.data() + (plus ? 1 : 0), last, value);
    if (end != last || error == std::errc::invalid_argument) {
        throw InputError("\"" + printable(std::string(word.substr(0, kShown))) +
                         "\" stands where a number must");
    }
    return error == std::errc::result_out_of_range ? std::strtod(std::string(word).c_str(), nullptr)
                                                   : value;
}

}  // namespace kerf::app
