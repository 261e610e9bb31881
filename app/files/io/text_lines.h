#pragma once

namespace kerf::app {

/// The byte order mark of UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
/// A text without it. Throws InputError for one in UTF-16.
std::string_view withoutMark(std::string_view text);

/// The lines of a text file with any line ends, after an optional byte order mark. Lines of an OBJ
/// continued by a backslash are one. Blanks around a line are removed.
class TextLines {
  public:
    explicit TextLines(std::string_view text);

    /// Goes to the next line. False at the end.
    bool next();
    /// The current line, until next().
    std::string_view line() const { return line_; }
    /// Its number in the file, from 1; of continued lines the first.
    std::size_t number() const { return number_; }

  private:
    std::string_view take();

    std::string_view rest_;
    std::string joined_;
    std::string_view line_;
    std::size_t number_ = 0;
    std::size_t read_ = 0;
};

/// Calls `read`, and adds the line to its InputError.
void namingLine(const TextLines& lines, const std::function<void()>& read);

/// Removes and returns the first word of a text; "" for none.
std::string_view takeWord(std::string_view& text);
/// A text without blanks at both ends.
std::string_view withoutBlanks(std::string_view text);
/// The number in a word, in any C notation; infinite or 0 if out of range. Throws InputError.
double numberOf(std::string_view word);

}  // namespace kerf::app
