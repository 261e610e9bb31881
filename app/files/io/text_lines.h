#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace kerf::app {

/// What programs put before a text in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
/// A text without that. Throws InputError for one in UTF-16.
std::string_view withoutMark(std::string_view text);

/// The lines of a text file, whatever ends them: behind a byte order mark, if there is one. Lines
/// of numbers in an OBJ that a backslash continues are one. Blanks around a line are left out.
class TextLines {
  public:
    explicit TextLines(std::string_view text);

    /// Goes to the next line. False at the end.
    bool next();
    /// The line as it is now, until next().
    std::string_view line() const { return line_; }
    /// Its number in the file, from 1; that of the first where several are one.
    std::size_t number() const { return number_; }

  private:
    std::string_view take();

    std::string_view rest_;
    std::string joined_;
    std::string_view line_;
    std::size_t number_ = 0;
    std::size_t read_ = 0;
};

/// Calls `read`. Where that throws InputError, so does this, and names the line.
void namingLine(const TextLines& lines, const std::function<void()>& read);

/// Takes the first word, between blanks, off a text; "" where there is none.
std::string_view takeWord(std::string_view& text);
/// A text without blanks at both ends.
std::string_view withoutBlanks(std::string_view text);
/// The number that a word is, in any notation of C; infinite, or 0, where no double holds it.
/// Throws InputError.
double numberOf(std::string_view word);

}  // namespace kerf::app
