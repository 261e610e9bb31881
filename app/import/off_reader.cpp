#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/text_lines.h"
#include "app/import/face_soup.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

/// The words of a text, without comments.
class OffWords {
  public:
    explicit OffWords(std::string_view text) : lines_(text) {}

    bool isAtEnd() {
        while (withoutBlanks(line_).empty()) {
            if (!lines_.next()) {
                return true;
            }
            line_ = withoutComment(lines_.line());
        }
        return false;
    }

    std::string_view next() {
        if (isAtEnd()) {
            throw InputError("it ends too early");
        }
        return takeWord(line_);
    }
    double number() { return numberOf(next()); }
    std::vector<double> numbers(std::size_t count) {
        std::vector<double> numbers;
        while (numbers.size() < count) {
            numbers.push_back(number());
        }
        return numbers;
    }
    /// The numbers that are left on the line.
    std::vector<double> rest() {
        std::vector<double> numbers;
        for (std::string_view word = takeWord(line_); !word.empty(); word = takeWord(line_)) {
            numbers.push_back(numberOf(word));
        }
        return numbers;
    }
    /// The number of edges, which says nothing: on this line, alone on the next one, or left out.
    void skipEdges() {
        if (!rest().empty() || !lines_.next()) {
            return;
        }
        line_ = withoutComment(lines_.line());
        std::string_view behind = line_;
        takeWord(behind);
        if (withoutBlanks(behind).empty()) {
            line_ = {};
        }
    }
    const TextLines& lines() const { return lines_; }

  private:
    /// In a word, as in "-1.#IND", it begins none.
    static std::string_view withoutComment(std::string_view line) {
        std::size_t at = line.find('#');
        while (at != std::string_view::npos && at > 0 && line[at - 1] != ' ' &&
               line[at - 1] != '\t') {
            at = line.find('#', at + 1);
        }
        return line.substr(0, at);
    }

    TextLines lines_;
    std::string_view line_;
};

/// What the vertices of a file have, by its first word: [ST][C][N][4][n]OFF. Some files have none,
/// and begin with their counts.
struct OffHead {
    bool uvs = false;
    bool colors = false;
    bool normals = false;
    bool weights = false;

    /// Takes itself off the word: a number may be glued to it.
    explicit OffHead(std::string_view& word) {
        if (word.find_first_not_of("0123456789") == std::string_view::npos) {
            return;
        }
        const auto has = [&](std::string_view letters) {
            const bool found = word.starts_with(letters);
            word.remove_prefix(found ? letters.size() : 0);
            return found;
        };
        uvs = has("ST");
        colors = has("C");
        normals = has("N");
        weights = has("4");
        if (has("n")) {
            throw InputError("it has other than three dimensions");
        }
        if (!has("OFF")) {
            throw InputError("it begins with neither OFF nor its counts");
        }
    }
};

std::size_t countOf(std::string_view word) {
    constexpr double kMost = 1e9;
    const double value = numberOf(word);
    if (!(value >= 0 && value <= kMost && value == std::floor(value))) {
        throw InputError("a count is " + formatNumber(value));
    }
    return static_cast<std::size_t>(value);
}

/// Of three or four numbers.
Eigen::Vector4f colorOf(const std::vector<double>& numbers) {
    return Eigen::Vector4d(numbers[0], numbers[1], numbers[2], numbers.size() > 3 ? numbers[3] : 1)
        .cast<float>();
}

/// A coloured vertex has what is left on its line.
void readVertex(const OffHead& head, OffWords& words, FaceSoup& faces) {
    const std::vector<double> at = words.numbers(head.weights ? 4 : 3);
    const double weight = head.weights && at[3] != 0 ? at[3] : 1;
    faces.positions.emplace_back(Vec3(at[0], at[1], at[2]) / weight);
    words.numbers(head.normals ? 3 : 0);
    std::vector<double> rest = words.rest();
    if (head.uvs && rest.size() >= 2) {
        faces.vertexUvs.emplace_back(rest[rest.size() - 2], rest.back());
        rest.resize(rest.size() - 2);
    }
    if (head.colors && rest.size() >= 3) {
        faces.vertexColors.resize(faces.positions.size() - 1, kNoColor);
        faces.vertexColors.push_back(colorOf(rest));
    }
}

/// One number behind the corners is that of a colour in a table of Geomview's. True for that.
bool readFace(OffWords& words, FaceSoup& faces) {
    const std::size_t corners = countOf(words.next());
    for (std::size_t i = 0; i < corners; ++i) {
        faces.addCorner(cornerOf(words.number()));
    }
    const std::vector<double> color = words.rest();
    if (color.size() >= 3 && corners > 2) {
        faces.faceColors.resize(faces.faceCount(), kNoColor);
        faces.faceColors.push_back(colorOf(color));
    }
    faces.endFace();
    return color.size() == 1;
}

void readAll(OffWords& words, FaceSoup& faces, std::vector<std::string>& remarks) {
    std::string_view word = words.next();
    const OffHead head(word);
    word = word.empty() ? words.next() : word;
    if (lowerCase(std::string(word)) == "binary") {
        throw InputError("it is a binary OFF, which is not read; export it as text, PLY or OBJ");
    }
    const std::size_t vertices = countOf(word);
    const std::size_t faceCount = countOf(words.next());
    words.skipEdges();
    for (std::size_t i = 0; i < vertices; ++i) {
        readVertex(head, words, faces);
    }
    bool table = false;
    for (std::size_t i = 0; i < faceCount; ++i) {
        table |= readFace(words, faces);
    }
    if (table) {
        remarks.emplace_back("Colours by their number in a table were left out: it has no table.");
    }
    if (!words.isAtEnd()) {
        remarks.push_back("What stands behind its last face, from line " +
                          std::to_string(words.lines().number()) +
                          " on, was left out: its first numbers count no more.");
    }
}

}  // namespace

ImportedModel readOff(const std::filesystem::path& file) {
    const std::string bytes = readInputFile(file, kMaxModelBytes);
    OffWords words(bytes);
    FaceSoup faces;
    ImportedModel model;
    namingLine(words.lines(), [&] { readAll(words, faces, model.remarks); });
    makeLinear(faces.vertexColors);
    makeLinear(faces.faceColors);
    takeFaces(faces, model);
    roundNearOrigin(model.soup);
    return model;
}

}  // namespace kerf::app
