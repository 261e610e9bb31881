#include "app/session/material.h"

#include <spdlog/fmt/fmt.h>

#include <tuple>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "gpu/data_path.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

MaterialProperty ofParam(const char* name, MaterialValue Material::*member) {
    // The table of parameters is made of literals, so its texts end in zero bytes.
    const ParamInfo& info = *findParam(name);
    return {name,  info.label.data(), info.unit.data(), info.meaning.data(), info.low, info.high,
            member};
}

/// "liver" of "liver.json", "phantom-3" of "phantom-3.material.json".
std::string nameOfFile(const fs::path& file) {
    const std::string name = file.filename().string();
    return isMaterialFile(file) ? name.substr(0, name.size() - kMaterialEnding.size())
                                : file.stem().string();
}

bool isJson(std::string_view name) {
    return lowerCase(std::string(name)).ends_with(".json");
}

/// The parameter of a property for a model; empty where it is that of all models.
std::string paramOf(const MaterialProperty& property, int model) {
    const std::string name = model > 0 ? ownName(property.name, model) : property.name;
    return findParam(name) != nullptr ? name : "";
}

/// A unit in which people read a value.
struct ShownUnit {
    double size;  ///< in the property's own unit
    std::string_view name;
};

ShownUnit unitFor(std::string_view unit, double value) {
    if (unit == "Pa" && value >= 1e3) {
        return value >= 1e6 ? ShownUnit{1e6, "MPa"} : ShownUnit{1e3, "kPa"};
    }
    if (unit == "m") {
        return {1e-3, "mm"};
    }
    return unit == "s" ? ShownUnit{1e-3, "ms"} : ShownUnit{1, unit};
}

std::string numberText(double value, const ShownUnit& unit) {
    return fmt::format("{:.5g}", value / unit.size);
}

bool isAbout(const MaterialSource& source, const MaterialProperty& property) {
    return std::ranges::find(source.of, property.name) != source.of.end();
}

/// Whether estimates are all that there is about a property.
bool isEstimate(const Material& material, const MaterialProperty& property) {
    const auto has = [&](bool estimate) {
        return std::ranges::any_of(material.sources, [&](const MaterialSource& source) {
            return source.estimate == estimate && isAbout(source, property);
        });
    };
    return has(true) && !has(false);
}

}  // namespace

std::span<const MaterialProperty> materialProperties() {
    static const std::array properties{
        ofParam("youngs_modulus", &Material::youngsModulus),
        ofParam("density", &Material::density),
        ofParam("friction", &Material::friction),
        ofParam("damping", &Material::damping),
        ofParam("toughness", &Material::toughness),
        ofParam("tensile_strength", &Material::tensileStrength),
        ofParam("skin_thickness", &Material::skinThickness),
        ofParam("skin_modulus", &Material::skinModulus),
        ofParam("skin_toughness", &Material::skinToughness),
        ofParam("skin_tensile_strength", &Material::skinStrength),
    };
    return properties;
}

std::vector<SetParam> settingsOf(const Material& material, int model) {
    std::vector<SetParam> settings;
    settings.reserve(materialProperties().size());
    for (const MaterialProperty& property : materialProperties()) {
        const std::string param = paramOf(property, model);
        const bool isSkin = property.member == &Material::skinThickness;
        std::optional<double> value = (material.*property.member).value;
        if (isSkin && !value) {
            value = 0;
        }
        if (!param.empty() && value) {
            settings.push_back({param, *value, false, material.label});
        }
    }
    return settings;
}

void applyMaterial(Params& params, const Material& material) {
    for (const SetParam& set : settingsOf(material)) {
        setParam(params, set.name, set.value);
    }
}

void applyMaterial(Session& session, const Material& material) {
    applyMaterial(session.params, material);
    session.material = material.name;
    if (!session.colors.any()) {
        session.colors = material.colors;
    }
}

bool isMadeOf(const Params& params, const Material& material, int model) {
    const std::vector<SetParam> settings = settingsOf(material, model);
    return !settings.empty() && std::ranges::all_of(settings, [&](const SetParam& set) {
        return getParam(params, set.name) == set.value;
    });
}

Material materialFrom(const Params& params, const render::ChosenColors& colors) {
    Material material;
    for (const MaterialProperty& property : materialProperties()) {
        if (params.skinThickness > 0 || !std::string_view(property.name).starts_with("skin_")) {
            (material.*property.member).value = std::get<double>(getParam(params, property.name));
        }
    }
    material.colors = colors;
    return material;
}

Material readMaterial(const fs::path& file) {
    const std::string text = readInputFile(file, kMaxMaterialBytes);
    try {
        Material material = parseMaterial(text);
        material.name = nameOfFile(file);
        if (material.label.empty()) {
            material.label = printable(material.name);
        }
        return material;
    } catch (const InputError& error) {
        throw InputError(file.filename().string() + ": " + error.what());
    }
}

std::vector<Material> materialsIn(const fs::path& folder, std::vector<std::string>& problems) {
    std::vector<Material> materials;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (!isJson(entry->path().filename().string())) {
            continue;
        }
        try {
            materials.push_back(readMaterial(entry->path()));
        } catch (const InputError& problem) {
            problems.emplace_back(problem.what());
        }
    }
    std::ranges::sort(materials, [](const Material& a, const Material& b) {
        return std::tie(a.label, a.name) < std::tie(b.label, b.name);
    });
    return materials;
}

const std::vector<Material>& builtinMaterials() {
    static const std::vector<Material> materials = [] {
        std::vector<std::string> problems;
        const fs::path folder = gpu::dataPath("assets/materials");
        std::vector<Material> read = materialsIn(folder, problems);
        if (!problems.empty()) {
            throw InputError(problems.front());
        }
        if (read.empty()) {
            throw InputError(folder.string() +
                             ": Kerf's materials are not there; install it anew.");
        }
        return read;
    }();
    return materials;
}

std::vector<std::string> materialNames() {
    std::vector<std::string> names;
    std::ranges::transform(builtinMaterials(), std::back_inserter(names), &Material::name);
    std::ranges::sort(names);
    return names;
}

bool namesMaterialFile(std::string_view text) {
    return isJson(text);
}

bool isMaterialFile(const fs::path& file) {
    return lowerCase(file.filename().string()).ends_with(kMaterialEnding);
}

Material findMaterial(const std::string& text, const fs::path& baseFolder) {
    if (namesMaterialFile(text)) {
        return readMaterial(baseFolder / text);
    }
    const auto found = std::ranges::find(builtinMaterials(), text, &Material::name);
    if (found == builtinMaterials().end()) {
        throw InputError("there is no material '" + shortened(text) + "'; there are " +
                         joined(materialNames(), ", ") + ", or name a file that ends in .json.");
    }
    return *found;
}

std::string valueText(const Material& material, const MaterialProperty& property) {
    const std::optional<double>& value = (material.*property.member).value;
    if (!value) {
        return "";
    }
    const ShownUnit unit = unitFor(property.unit, *value);
    return numberText(*value, unit).append(unit.name.empty() ? "" : " ").append(unit.name);
}

std::string describeProperty(const Material& material, const MaterialProperty& property) {
    const MaterialValue& value = material.*property.member;
    if (!value.value) {
        return "";
    }
    std::string line(property.label);
    line.append(": ").append(valueText(material, property));
    if (value.low && value.high) {
        const ShownUnit unit = unitFor(property.unit, *value.value);
        line.append(" (").append(numberText(*value.low, unit)).append(" to ");
        line.append(numberText(*value.high, unit)).append(")");
    }
    return line.append(isEstimate(material, property) ? ", an estimate" : "");
}

std::vector<std::string> describeSources(const Material& material,
                                         const MaterialProperty& property) {
    std::vector<std::string> lines;
    for (const MaterialSource& source : material.sources) {
        if (!isAbout(source, property)) {
            continue;
        }
        std::string line = source.estimate ? "Estimate: " + source.text : source.text;
        if (!source.says.empty()) {
            line.append(": ").append(source.says);
        }
        if (!source.doi.empty()) {
            line.append(", doi:").append(source.doi);
        }
        lines.push_back(printable(line));
    }
    return lines;
}

std::string describeMaterial(const Material& material) {
    std::string text = printable(material.about);
    for (const MaterialProperty& property : materialProperties()) {
        const std::string line = describeProperty(material, property);
        text.append(line.empty() || text.empty() ? "" : "\n").append(line);
    }
    bool first = true;
    for (const MaterialSource& source : material.sources) {
        if (!source.estimate) {
            text.append(first ? "\nSources:\n" : "\n").append(printable(source.text));
            first = false;
        }
    }
    return text;
}

fs::path defaultMaterialFolder() {
    return gpu::userPath("XDG_DATA_HOME", ".local/share", "materials");
}

}  // namespace kerf::app
