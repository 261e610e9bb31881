#pragma once

namespace kerf::app {

/// A type of numbers in files, by both of its names.
struct Scalar {
    std::string_view name;
    std::string_view other;
    std::size_t bytes;
    double most;                    ///< that of a colour; 1 where it says not which
    double (*number)(const char*);  ///< in so many bytes of this machine's order
};

/// The type of that name, such as "uchar", "uint8" or "double"; null for none.
const Scalar* findScalar(std::string_view name);

enum class Encoding { text, littleEndian, bigEndian };

/// The numbers and words of a file, one after the other. A number that is not there throws
/// InputError.
class FileNumbers {
  public:
    FileNumbers(std::string_view bytes, Encoding encoding)
        : bytes_(bytes), rest_(bytes), encoding_(encoding) {}

    void setEncoding(Encoding encoding) { encoding_ = encoding; }

    double next(const Scalar& type) {
        return encoding_ == Encoding::text ? textNumber() : binaryNumber(type);
    }
    /// The next `count` of them.
    std::vector<double> list(const Scalar& type, double count);
    /// All that are left.
    std::vector<double> all(const Scalar& type);

    /// The next word of a text; "" at the end.
    std::string_view word();
    /// What is left of the line of a text, without its end and blanks around it.
    std::string_view line();
    /// Whether blanks and zeros are all that is left.
    bool isAtEnd() const;
    std::string_view rest() const { return rest_; }
    void skip(std::size_t bytes) { rest_.remove_prefix(std::min(bytes, rest_.size())); }
    /// Where that is: "line 3", or "byte 700" where numbers are binary.
    std::string place() const;

  private:
    double textNumber();
    double binaryNumber(const Scalar& type);

    std::string_view bytes_;
    std::string_view rest_;
    Encoding encoding_;
};

/// Calls `read`, and adds the place to its InputError.
void namingPlace(const FileNumbers& numbers, const std::function<void()>& read);

}  // namespace kerf::app
