#include "app/files/import/obj_materials.h"

#include "app/files/import/import_appearance.h"
#include "app/files/io/text_lines.h"

namespace kerf::app {
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
