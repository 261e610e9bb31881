#include "app/files/off_reader.h"

#include <algorithm>
#include <array>
#include <vector>

#include "app/files/face_soup.h"
#include "app/files/file_io.h"
#include "app/files/model_source.h"
#include "app/files/text_lines.h"
#include "render/scene/body_look.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

/// What the vertices of a file have, by its first word: [ST][C][N][4][n]OFF.
struct OffHead {
    bool uvs = false;
    bool colors = false;
    bool normals = false;
    bool weights = false;

    static OffHead of(std::string_view word) {
        const auto has = [&](std::string_view letters) {
            const bool found = word.starts_with(letters);
            word.remove_prefix(found ? letters.size() : 0);
            return found;
        };
        OffHead head;
        head.uvs = has("ST");
        head.colors = has("C");
        head.normals = has("N");
        head.weights = has("4");
        if (has("n")) {
            throw InputError("it has other than three dimensions");
        }
        if (word != "OFF") {
            throw InputError("it does not begin with OFF");
        }
        return head;
    }
};

/// The words of a text, without comments.
class OffWords {
  public:
    explicit OffWords(std::string_view text) : lines_(text) {}

    std::string_view next() {
        while (true) {
            if (const std::string_view word = takeWord(line_); !word.empty()) {
                return word;
            }
            if (!lines_.next()) {
                throw InputError("it ends too early");
            }
            line_ = lines_.line().substr(0, lines_.line().find('#'));
        }
    }
    double number() { return numberOf(next()); }
    std::vector<double> numbers(std::size_t count) {
        std::vector<double> numbers;
        while (numbers.size() < count) {
            numbers.push_back(number());
        }
        return numbers;
    }
    std::size_t count() {
        constexpr double kMost = 1e9;
        const double value = number();
        if (!(value >= 0 && value <= kMost)) {
            throw InputError("a count is " + formatNumber(value));
        }
        return static_cast<std::size_t>(value);
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
        line_ = lines_.line().substr(0, lines_.line().find('#'));
        std::string_view behind = line_;
        takeWord(behind);
        if (withoutBlanks(behind).empty()) {
            line_ = {};
        }
    }
    std::size_t line() const { return lines_.number(); }

  private:
    TextLines lines_;
    std::string_view line_;
};

/// Of three or four numbers: shares, or bytes where one is above 1.
Eigen::Vector4f colorOf(const std::vector<double>& numbers) {
    const double most = *std::ranges::max_element(numbers) > 1 ? 255 : 1;
    const Vec3f linear = render::toLinear(Vec3(numbers[0], numbers[1], numbers[2]) / most);
    return {linear.x(), linear.y(), linear.z(),
            numbers.size() > 3 ? static_cast<float>(numbers[3] / most) : 1};
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
        faces.vertexColors.resize(faces.positions.size() - 1, Eigen::Vector4f::Ones());
        faces.vertexColors.push_back(colorOf(rest));
    }
}

/// One number behind the corners would be that of a colour in a table of Geomview's.
void readFace(OffWords& words, FaceSoup& faces) {
    const std::size_t corners = words.count();
    for (std::size_t i = 0; i < corners; ++i) {
        faces.addCorner(static_cast<int>(std::clamp(words.number(), -1.0, 2e9)));
    }
    if (const std::vector<double> color = words.rest(); color.size() >= 3 && corners > 2) {
        faces.faceColors.resize(faces.faceCount(), Eigen::Vector4f::Ones());
        faces.faceColors.push_back(colorOf(color));
    }
    faces.endFace();
}

void readAll(OffWords& words, FaceSoup& faces) {
    const OffHead head = OffHead::of(words.next());
    const std::string_view first = words.next();
    if (lowerCase(std::string(first)) == "binary") {
        throw InputError("it is a binary OFF, which is not read; export it as text, PLY or OBJ");
    }
    const auto vertices = static_cast<std::size_t>(std::clamp(numberOf(first), 0.0, 1e9));
    const std::size_t faceCount = words.count();
    words.skipEdges();
    for (std::size_t i = 0; i < vertices; ++i) {
        readVertex(head, words, faces);
    }
    for (std::size_t i = 0; i < faceCount; ++i) {
        readFace(words, faces);
    }
}

}  // namespace

ImportedModel readOff(const std::filesystem::path& file) {
    const std::string bytes = readInputFile(file, kMaxModelBytes);
    OffWords words(bytes);
    FaceSoup faces;
    try {
        readAll(words, faces);
    } catch (const InputError& error) {
        throw InputError("line " + std::to_string(words.line()) + ": " + error.what());
    }
    ImportedModel model;
    takeFaces(faces, model);
    roundNearOrigin(model.soup);
    return model;
}

}  // namespace kerf::app
