#include "app/import/obj_reader.h"

#include <charconv>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/text_lines.h"
#include "app/import/appearance_reader.h"
#include "app/import/face_soup.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

/// What says nothing about the shape and looks of a surface.
constexpr std::array<std::string_view, 13> kSaysNothing{
    "vn",       "l",        "p",          "s",         "mg",     "lod",   "bevel",
    "c_interp", "d_interp", "shadow_obj", "trace_obj", "usemap", "maplib"};
constexpr std::size_t kMostNamed = 3;                     // unknown words in a remark
constexpr std::uint64_t kMostMaterialBytes = 16'000'000;  // of an .mtl file

/// A number of a list that has `count` so far, which counts from 1, or backwards from its end.
int indexOf(std::string_view text, std::size_t count, std::string_view corner) {
    long long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const long long index = number < 0 ? static_cast<long long>(count) + number : number - 1;
    if (error != std::errc() || end != text.data() + text.size() || index < 0 ||
        index > std::numeric_limits<int>::max()) {
        throw InputError("\"" + printable(std::string(corner.substr(0, 40))) +
                         "\" stands where a corner must");
    }
    return static_cast<int>(index);
}

/// Collects what the lines of a file say.
class ObjModel {
  public:
    void readLine(std::string_view line) {
        line = line.substr(0, line.find('#'));
        const std::string_view key = takeWord(line);
        if (key.empty()) {
            return;
        }
        if (key == "v") {
            addVertex(line);
        } else if (key == "vt") {
            addUv(line);
        } else if (key == "f" || key == "fo") {
            addFace(line);
        } else if (key == "o" || key == "g") {
            enterObject(key, line);
        } else if (std::ranges::find(kSaysNothing, key) == kSaysNothing.end()) {
            unknown.insert(std::string(key));
        }
    }
    /// The faces that follow are of this material.
    void useMaterial(std::string_view name) {
        const auto [place, isNew] =
            numbers_.try_emplace(std::string(name), static_cast<int>(names.size()));
        material_ = place->second;
        if (isNew) {
            names.emplace_back(name);
        }
    }

    FaceSoup& faces() {
        makeLinear(faces_.vertexColors);
        return faces_;
    }

    std::set<std::string> unknown;   ///< words at the beginning of lines
    std::vector<std::string> names;  ///< of materials, by the numbers in the triangles

  private:
    /// A file without objects may have a group for each.
    void enterObject(std::string_view key, std::string_view name) {
        hasObjects_ |= key == "o";
        if (key == "o" || !hasObjects_) {
            faces_.enterObject(std::string(withoutBlanks(name)));
        }
    }

    static std::vector<double> numbersIn(std::string_view line) {
        std::vector<double> numbers;
        for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
            numbers.push_back(numberOf(word));
        }
        return numbers;
    }

    /// x y z, then nothing, a weight, or a colour.
    void addVertex(std::string_view line) {
        const std::vector<double> numbers = numbersIn(line);
        if (numbers.size() < 3) {
            throw InputError("a vertex has " + std::to_string(numbers.size()) +
                             " numbers, and needs three");
        }
        const double weight = numbers.size() == 4 && numbers[3] != 0 ? numbers[3] : 1;
        if (numbers.size() >= 6) {
            faces_.vertexColors.resize(faces_.positions.size(), kNoColor);
            faces_.vertexColors.push_back(
                Eigen::Vector4d(numbers[3], numbers[4], numbers[5], 1).cast<float>());
        }
        faces_.positions.emplace_back(Vec3(numbers[0], numbers[1], numbers[2]) / weight);
    }

    void addUv(std::string_view line) {
        std::vector<double> numbers = numbersIn(line);
        numbers.resize(2);
        faces_.uvs.emplace_back(numbers[0], numbers[1]);
    }

    void addFace(std::string_view line) {
        for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
            addCorner(word);
        }
        faces_.endFace(material_);
    }

    /// v, v/vt, v//vn or v/vt/vn.
    void addCorner(std::string_view word) {
        const std::size_t slash = std::min(word.find('/'), word.size());
        const std::string_view behind = word.substr(std::min(slash + 1, word.size()));
        const std::string_view uv = behind.substr(0, behind.find('/'));
        faces_.addCorner(indexOf(word.substr(0, slash), faces_.positions.size(), word),
                         uv.empty() ? FaceSoup::kNone : indexOf(uv, faces_.uvs.size(), word));
    }

    FaceSoup faces_;
    bool hasObjects_ = false;
    int material_ = FaceSoup::kNone;
    std::map<std::string, int> numbers_;  ///< of materials, by name
};

/// The materials of the libraries that a file names.
class Libraries {
  public:
    Libraries(const std::filesystem::path& model, std::vector<std::string>& remarks)
        : model_(model), remarks_(remarks) {}

    /// One name with blanks, or several.
    void open(std::string_view names) {
        std::string_view rest = names;
        bool any = read(std::string(names));
        std::vector<std::string> missing;
        for (std::string_view word = takeWord(rest); !any && !word.empty(); word = takeWord(rest)) {
            missing.emplace_back(word);
        }
        const std::size_t words = missing.size();
        std::erase_if(missing, [&](const std::string& word) { return read(word); });
        if (!any && missing.size() == words) {
            missing = {std::string(names)};
        }
        for (const std::string& name : missing) {
            complete_ = false;
            remarks_.push_back("The materials of \"" + printable(name) +
                               "\" were left out: there is no such file in the model's folder "
                               "or below; put it there and open the model again.");
        }
    }
    /// Null where no library has it; that is told where all of them were there.
    const ObjMaterial* find(const std::string& name) {
        const auto found = materials_.find(name);
        if (found != materials_.end()) {
            return &found->second;
        }
        if (complete_) {
            remarks_.push_back("The material \"" + printable(name) +
                               "\" was left out: no .mtl file of the model has it.");
        }
        return nullptr;
    }

  private:
    bool read(const std::string& name) {
        const std::optional<std::filesystem::path> file = fileBeside(model_, name);
        try {
            for (ObjMaterial& material :
                 file ? readObjMaterials(readInputFile(*file, kMostMaterialBytes))
                      : std::vector<ObjMaterial>{}) {
                materials_.try_emplace(material.material.name, std::move(material));
            }
        } catch (const InputError& error) {
            complete_ = false;
            remarks_.push_back("The materials of \"" + printable(name) +
                               "\" were left out: " + error.what() + ".");
        }
        return file.has_value();
    }

    const std::filesystem::path& model_;
    std::vector<std::string>& remarks_;
    std::map<std::string, ObjMaterial> materials_;
    bool complete_ = true;
};

void readStatement(std::string_view line, ObjModel& read, Libraries& libraries) {
    std::string_view rest = line;
    const std::string_view key = takeWord(rest);
    if (key == "mtllib") {
        libraries.open(withoutBlanks(rest));
    } else if (key == "usemtl") {
        read.useMaterial(withoutBlanks(rest));
    } else {
        read.readLine(line);
    }
}

void readLines(std::string_view text, ObjModel& read, Libraries& libraries) {
    TextLines lines(text);
    namingLine(lines, [&] {
        while (lines.next()) {
            readStatement(lines.line(), read, libraries);
        }
    });
}

void addMaterials(const std::vector<std::string>& names, Libraries& libraries,
                  const std::filesystem::path& file, ImportedModel& model) {
    ModelImages images(file, model);
    takeMaterials(model, [&](int number) {
        const ObjMaterial* const found = libraries.find(names[number]);
        if (found == nullptr) {
            return -1;
        }
        const int added = images.add(found->material, found->image);
        if (!found->leftOut.empty()) {
            model.remarks.push_back("The image of the material \"" + printable(names[number]) +
                                    "\" is shown as it is: what its .mtl file says by " +
                                    found->leftOut + " was left out.");
        }
        return added;
    });
}

void tellUnknown(const std::set<std::string>& words, std::vector<std::string>& remarks) {
    std::vector<std::string> named;
    for (const std::string& word : words) {
        if (named.size() < kMostNamed) {
            named.push_back("\"" + printable(word.substr(0, 40)) + "\"");
        }
    }
    if (!named.empty()) {
        remarks.push_back("Lines that begin with " + joined(named, ", ") +
                          (words.size() > named.size() ? " and other words" : "") +
                          " were left out: Kerf does not know them.");
    }
}

}  // namespace

ImportedModel readObj(const std::filesystem::path& file) {
    const std::string bytes = readInputFile(file, kMaxModelBytes);
    ImportedModel model;
    ObjModel read;
    Libraries libraries(file, model.remarks);
    readLines(bytes, read, libraries);
    takeFaces(read.faces(), model);
    roundNearOrigin(model.soup);
    addMaterials(read.names, libraries, file, model);
    tellUnknown(read.unknown, model.remarks);
    return model;
}

namespace {

/// An option of a picture, and how many words follow it at most; numbers where `ofNumbers`.
struct ImageOption {
    std::string_view name;
    int words;
    bool ofNumbers = false;
    bool movesImage = false;
};
constexpr std::array kImageOptions{
    ImageOption{"-blendu", 1},        ImageOption{"-blendv", 1},
    ImageOption{"-boost", 1, true},   ImageOption{"-mm", 2, true},
    ImageOption{"-o", 3, true, true}, ImageOption{"-s", 3, true, true},
    ImageOption{"-t", 3, true, true}, ImageOption{"-texres", 1, true},
    ImageOption{"-clamp", 1},         ImageOption{"-bm", 1, true},
    ImageOption{"-imfchan", 1},       ImageOption{"-type", 1},
    ImageOption{"-colorspace", 1},
};

bool isNumber(std::string_view word) {
    return !word.empty() && word.find_first_not_of("+-.0123456789eE") == std::string_view::npos;
}

/// The file behind the options of a picture; blanks may be in its name.
void readImage(std::string_view rest, ObjMaterial& material) {
    while (true) {
        std::string_view behind = rest;
        const std::string_view word = takeWord(behind);
        const auto* const option = std::ranges::find(kImageOptions, word, &ImageOption::name);
        if (option == kImageOptions.end()) {
            material.image = withoutBlanks(rest);
            return;
        }
        material.leftOut = option->movesImage ? option->name : material.leftOut;
        rest = behind;
        for (int i = 0; i < option->words; ++i) {
            const std::string_view next = takeWord(behind);
            rest = option->ofNumbers && !isNumber(next) ? rest : behind;
        }
    }
}

float share(double number) {
    return std::isfinite(number) ? static_cast<float>(std::clamp(number, 0.0, 1.0)) : 1;
}

/// `Kd 0.5` is grey; a spectrum, or a colour in XYZ, is not read.
void readColor(std::string_view rest, render::SurfaceMaterial& material) {
    for (int i = 0; i < 3; ++i) {
        const std::string_view word = takeWord(rest);
        material.baseColor[i] =
            word.empty() ? material.baseColor[i - 1] : static_cast<float>(numberOf(word));
    }
}

/// The last word, since options may stand before it ("d -halo 0.5").
double lastNumber(std::string_view rest) {
    const std::size_t at = rest.find_last_of(" \t");
    return numberOf(at == std::string_view::npos ? rest : rest.substr(at + 1));
}

struct MaterialLines {
    std::vector<ObjMaterial> all;
    bool hasRoughness = false;

    void read(std::string_view line) {
        const std::string_view key = takeWord(line);
        const std::string_view rest = withoutBlanks(line);
        if (key == "newmtl") {
            all.emplace_back().material.name = rest;
            hasRoughness = false;
        } else if (!all.empty() && !rest.empty()) {
            readProperty(key, rest, all.back());
        }
    }

    void readProperty(std::string_view key, std::string_view rest, ObjMaterial& to) {
        render::SurfaceMaterial& material = to.material;
        if (key == "Kd") {
            readColor(rest, material);
        } else if (key == "d") {
            material.baseColor.w() = share(lastNumber(rest));
        } else if (key == "Tr") {
            material.baseColor.w() = 1 - share(lastNumber(rest));
        } else if (key == "Pr") {
            material.roughness = share(lastNumber(rest));
            hasRoughness = true;
        } else if (key == "Ns" && !hasRoughness) {
            const double exponent = lastNumber(rest);
            material.roughness = exponent > 0 ? roughnessOfHighlight(exponent) : material.roughness;
        } else if (key == "Pm") {
            material.metallic = share(lastNumber(rest));
        } else if (key == "map_Kd") {
            readImage(rest, to);
        }
    }
};

}  // namespace

std::vector<ObjMaterial> readObjMaterials(std::string_view text) {
    MaterialLines lines;
    TextLines file(text);
    namingLine(file, [&] {
        while (file.next()) {
            lines.read(file.line());
        }
    });
    return std::move(lines.all);
}

}  // namespace kerf::app
