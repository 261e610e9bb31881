#pragma once

#include "app/session/session.h"
#include "render/scene/body_look.h"
#include "sim/base/params.h"

namespace kerf::app {

/// Limits of a material file; beyond them it is refused.
inline constexpr std::uintmax_t kMaxMaterialBytes = 1u << 20;
inline constexpr std::size_t kMostSources = 100;
/// That which a model file is given when it is opened.
inline constexpr const char* kMaterialOfNewModel = "silicone";
/// The ending of user files; built-in ones are NAME.json.
inline constexpr std::string_view kMaterialEnding = ".material.json";

/// A quantity of a material, with the range of measurements.
struct MaterialValue {
    std::optional<double> value;  ///< a typical one; none if unknown
    std::optional<double> low;    ///< the ends of the range
    std::optional<double> high;
};

/// The source of values.
struct MaterialSource {
    std::vector<std::string> of;  ///< names of properties
    std::string text;             ///< paper, table; or the reason of an estimate
    std::string says;             ///< what it says; may be empty
    std::string doi;              ///< may be empty
    bool estimate = false;        ///< not measured
};

/// What a body is made of, by name. See docs/materials.md.
struct Material {
    std::string name;   ///< of its file, without endings: "liver"
    std::string label;  ///< for people: "Liver"
    std::string about;  ///< a description; may be empty
    MaterialValue youngsModulus;
    MaterialValue density;
    MaterialValue friction;
    MaterialValue damping;
    MaterialValue toughness;
    MaterialValue tensileStrength;
    MaterialValue skinThickness;
    MaterialValue skinModulus;
    MaterialValue skinToughness;
    MaterialValue skinStrength;
    render::ChosenColors colors;
    std::vector<MaterialSource> sources;
};

/// A row of the table of material properties.
struct MaterialProperty {
    const char* name;     ///< in files; that of the parameter
    const char* label;    ///< for people
    const char* unit;     ///< "" for none
    const char* meaning;  ///< one sentence
    double low;           ///< smallest value of the parameter
    double high;          ///< largest
    MaterialValue Material::*member;
};
std::span<const MaterialProperty> materialProperties();

/// The parameters that a material sets, in the order of the properties. For a model after the first
/// only per-model ones. A material without a skin sets its thickness to 0 and nothing else of it.
std::vector<SetParam> settingsOf(const Material& material, int model = 0);
/// Gives parameters the values of a material.
void applyMaterial(Params& params, const Material& material);
/// Gives a session the values of a material, and its look if the session has none.
void applyMaterial(Session& session, const Material& material);
/// Whether the parameters have all values of the material; for a model after the first, the
/// per-model ones.
bool isMadeOf(const Params& params, const Material& material, int model = 0);
/// The values of parameters as a material without sources and spread; of a skin, if it has one.
Material materialFrom(const Params& params, const render::ChosenColors& colors);

/// Reads and checks a material. Throws InputError naming the file and the place in it
/// ("liver.json: density.value: expected a number (10 to 20000).").
Material readMaterial(const std::filesystem::path& file);
/// Reads and checks the text of a material. Throws InputError naming the place in it.
Material parseMaterial(const std::string& text);
/// Text of a material file.
std::string formatMaterial(const Material& material);

/// The built-in materials, by label: the files of assets/materials.
const std::vector<Material>& builtinMaterials();
/// The names of these.
std::vector<std::string> materialNames();
/// The materials of a folder, by label. Unreadable files are skipped, with a sentence in
/// `problems`. A missing folder has none.
std::vector<Material> materialsIn(const std::filesystem::path& folder,
                                  std::vector<std::string>& problems);
/// The material of a builtin name, or of a file relative to `baseFolder` if `text` ends in ".json".
/// Throws InputError, which lists the names for an unknown one.
Material findMaterial(const std::string& text, const std::filesystem::path& baseFolder);
/// Whether a text names a file rather than a builtin material.
bool namesMaterialFile(std::string_view text);
/// Whether a file has the ending of user files.
bool isMaterialFile(const std::filesystem::path& file);

/// A value in a suitable unit: "5.4 kPa"; empty if unknown.
std::string valueText(const Material& material, const MaterialProperty& property);
/// One line about a property of a material: "Density: 1060 kg/m^3 (1050 to 1070)", "Friction: 0.2,
/// an estimate". Empty if its value is unknown.
std::string describeProperty(const Material& material, const MaterialProperty& property);
/// The sources of a property's value, a line each: "Estimate: A wet gel".
std::vector<std::string> describeSources(const Material& material,
                                         const MaterialProperty& property);

/// All of a material in a few lines, for people: what it is, its values, the names of its sources.
std::string describeMaterial(const Material& material);
/// The user's folder of materials: $XDG_DATA_HOME/kerf/materials, by default in ~/.local/share;
/// empty without a home.
std::filesystem::path defaultMaterialFolder();

}  // namespace kerf::app
