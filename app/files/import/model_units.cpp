#include "app/files/import/model_units.h"

#include "sim/base/math.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

// The longest side of what people cut, if nothing else is known [m].
constexpr double kSmall = 0.005;
constexpr double kLarge = 5;

constexpr double kFloorGap = 0.02;  // of the diagonal

/// The customs of a format, or its rules.
struct Customs {
    const char* extension;
    const char* name;
    std::vector<LengthUnit> units;  ///< the most usual one first
    UpAxis up;
    bool certain;  ///< by the definition of the format, or its file says it
};

const std::vector<Customs>& customs() {
    using enum LengthUnit;
    static const std::vector<Customs> list = {
        {".obj", "OBJ", {metre, centimetre, millimetre}, UpAxis::y, false},
        {".ply", "PLY", {metre, centimetre, millimetre}, UpAxis::y, false},
        {".off", "OFF", {metre, centimetre, millimetre}, UpAxis::y, false},
        {".3ds", "3DS", {metre, centimetre, millimetre}, UpAxis::y, false},
        {".stl", "STL", {millimetre, metre}, UpAxis::z, false},
        {".fbx", "FBX", {centimetre, metre}, UpAxis::y, false},
        {".gltf", "glTF", {metre}, UpAxis::y, true},
        {".glb", "glTF", {metre}, UpAxis::y, true},
        {".dae", "DAE", {metre}, UpAxis::y, true},
        {".vtk", "VTK", {metre, centimetre, millimetre}, UpAxis::y, false},
        {".vtp", "VTK", {metre, centimetre, millimetre}, UpAxis::y, false},
        {".vtu", "VTK", {metre, centimetre, millimetre}, UpAxis::y, false},
        {".msh", "Gmsh", {metre, centimetre, millimetre}, UpAxis::y, false},
    };
    return list;
}

const Customs& customsOf(const std::filesystem::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    const auto found = std::ranges::find_if(
        customs(), [&](const Customs& format) { return extension == format.extension; });
    return found == customs().end() ? customs().front() : *found;
}

double lengthOf(const Bounds& own) {
    return own.empty() ? 0 : (own.high - own.low).maxCoeff();
}

/// How far a length is from what people cut, as a ratio; 1 where it is in the range.
double strangeness(double metres) {
    return std::max({1.0, metres / kLarge, metres > 0 ? kSmall / metres : 1.0});
}

LengthUnit likeliest(const Customs& format, double length) {
    return *std::ranges::min_element(format.units, {}, [&](LengthUnit unit) {
        return strangeness(infoOf(unit).metres * length);
    });
}

std::string sentenceFor(const Customs& format, LengthUnit unit, double length) {
    const std::string size = lengthText(infoOf(unit).metres * length);
    const std::string up(nameOf(format.up));
    const std::string axis = (up.starts_with('-') ? " with " : " with +") + up + " up";
    const std::string units(infoOf(unit).plural);
    if (format.certain) {
        return std::string(format.name) + " is in " + units + axis + ": " + size + " long.";
    }
    const LengthUnit usual = format.units.front();
    const std::string taken =
        std::string(format.name) + " has no unit: assumed " + units + axis + ", " + size + " long";
    if (unit == usual) {
        return taken + ".";
    }
    const double usually = infoOf(usual).metres * length;
    return taken + ", since " + lengthText(usually) + " would be " +
           (usually > kLarge ? "huge." : "tiny.");
}

}  // namespace

UnitGuess guessUnits(const std::filesystem::path& file, const Bounds& own,
                     const std::optional<FileUnits>& said) {
    Customs format = customsOf(file);
    if (said) {
        format.units = {said->unit};
        format.up = said->up;
        format.certain = true;
    }
    const double length = lengthOf(own);
    const LengthUnit unit = likeliest(format, length);
    return {unit, format.up, format.certain, sentenceFor(format, unit, length)};
}

Bounds placedBounds(std::span<const Vec3> own, const Placement& placement) {
    const PlacementMap map(placement);
    return boxOf(own, [&](const Vec3& point) { return map.toScene(point); });
}

Placement standing(const UnitGuess& guess, std::span<const Vec3> own) {
    Placement placement;
    placement.unit = guess.unit;
    placement.up = guess.up;
    return standing(placement, own, Vec3::Zero());
}

Placement standing(Placement placement, std::span<const Vec3> own, const Vec3& ground) {
    placement.translate = Vec3::Zero();
    const Bounds placed = placedBounds(own, placement);
    const Vec3 middle = placed.center();
    placement.translate = ground - Vec3(middle.x(), placed.low.y(), middle.z());
    placement.translate.y() += kFloorGap * placed.diagonal();
    return placement;
}

}  // namespace kerf::app
