// Files as other programs write them (format_corners/): each is read right, or refused by a
// sentence that says what and where; none gives another shape, or loses something, in silence.
#include "app/files/import/model_units.h"
#include "app/files/jobs/child_process.h"

namespace kerf::app {
namespace {

enum class Verdict { right, refused, silent, needless, unclear };
const std::map<Verdict, std::string> kVerdicts{
    {Verdict::right, "right"},
    {Verdict::refused, "refused by name"},
    {Verdict::silent, "silent"},
    {Verdict::needless, "refused needlessly"},
    {Verdict::unclear, "refused without a reason"},
};

/// What Kerf makes of a file.
struct Reading {
    std::string refusal;  ///< "" where it was read
    MeshReport report;
    std::optional<ModelMesh> model;
};

Reading readingOf(const fs::path& file) {
    Reading reading;
    ReadOptions options;
    options.report = &reading.report;
    try {
        reading.model = readModel(file, options);
    } catch (const InputError& error) {
        reading.refusal = error.what();
    }
    return reading;
}

bool isNear(double a, double b, double least = 0.1) {
    return std::abs(a - b) <= 1e-5 * std::max({std::abs(a), std::abs(b), least});
}

template <class Numbers>
bool areNear(const Numbers& own, const Json& right) {
    bool near = true;
    for (std::size_t i = 0; i < right.size(); ++i) {
        near = near && isNear(own[i], right[i].get<double>());
    }
    return near;
}

/// Whether the corners of a skin have all of these values, and no others.
template <class Corners>
bool haveAll(const std::vector<Corners>& skin, const Json& values) {
    std::vector<bool> found(values.size(), false);
    for (const Corners& corners : skin) {
        for (const auto& own : corners) {
            const auto same =
                std::ranges::find_if(values, [&](const Json& v) { return areNear(own, v); });
            if (same == values.end()) {
                return false;
            }
            found[std::size_t(same - values.begin())] = true;
        }
    }
    return std::ranges::count(found, false) == 0;
}

bool haveAllMaterials(const OwnLooks& looks, const Json& right) {
    const auto count = looks.appearance == nullptr ? 0 : looks.appearance->materials.size();
    bool same = count == right.size();
    for (std::size_t i = 0; same && i < count; ++i) {
        const render::SurfaceMaterial& own = looks.appearance->materials[i];
        same = right.contains(own.name) && areNear(own.baseColor, right[own.name]);
    }
    return same;
}

bool areRemarked(const std::vector<std::string>& remarks, const Json& right) {
    bool all = remarks.size() == right.size();
    for (std::size_t i = 0; all && i < right.size(); ++i) {
        const std::string words = right[i];
        all = std::ranges::any_of(
            remarks, [&](const std::string& r) { return r.find(words) != std::string::npos; });
    }
    return all;
}

/// As it is for people who ask.
Json guessOf(const fs::path& file) {
    const std::string call = "'" + kerfProgram().string() + "' inspect --json '" + file.string() +
                             "' > '" + file.string() + ".json' 2> /dev/null";
    const bool done = std::system(call.c_str()) == 0;
    return done ? Json::parse(readBytes(file.string() + ".json"))["guess"] : Json::object();
}

/// The facts of a row that are otherwise; "" for none.
std::string differences(const Json& row, const Reading& reading, const fs::path& file) {
    const ModelMesh& model = *reading.model;
    const render::Appearance none;
    const render::Appearance& looks = model.looks.appearance ? *model.looks.appearance : none;
    const MeshReport& report = reading.report;
    std::string wrong;
    const auto hold = [&](bool same, const std::string& what) {
        wrong += same ? "" : (wrong.empty() ? "" : ", ") + what;
    };
    const auto has = [&](const char* key) { return row.contains(key); };
    hold(isNear(report.volume, row["volume"], 0), "volume " + formatNumber(report.volume));
    hold(report.triangles == row["triangles"], "triangles " + std::to_string(report.triangles));
    hold(report.pieces == row["pieces"], "pieces " + std::to_string(report.pieces));
    hold(areNear(report.bounds.low, row["low"]) && areNear(report.bounds.high, row["high"]),
         "bounds");
    hold(!has("materials") || haveAllMaterials(model.looks, row["materials"]), "materials");
    hold(!has("images") || looks.images.size() == row["images"], "images");
    hold(!has("colors") || haveAll(model.looks.skin.colors, row["colors"]), "colours");
    hold(!has("uvs") || haveAll(model.looks.skin.uvs, row["uvs"]), "texture coordinates");
    hold(areRemarked(model.remarks, row.value("remarks", Json::array())),
         "remarks: " + joined(model.remarks, " "));
    if (has("unit") || has("up")) {
        const Json guess = guessOf(file);
        hold(guess.value("unit", "") == row.value("unit", guess.value("unit", "")), "unit");
        hold(guess.value("up", "") == row.value("up", guess.value("up", "")), "up axis");
    }
    return wrong;
}

/// The verdict on a row, and why.
struct Judgement {
    Verdict verdict;
    std::string why;
};

Judgement judgementOf(const Json& row, const fs::path& file) {
    const Reading reading = readingOf(file);
    if (row.contains("refused")) {
        const bool named = std::ranges::all_of(row["refused"], [&](const Json& words) {
            return reading.refusal.find(words.get<std::string>()) != std::string::npos;
        });
        return reading.refusal.empty()
                   ? Judgement{Verdict::silent, "volume " + formatNumber(reading.report.volume)}
                   : Judgement{named ? Verdict::refused : Verdict::unclear, reading.refusal};
    }
    if (!reading.model) {
        return {Verdict::needless, reading.refusal};
    }
    const std::string wrong = differences(row, reading, file);
    return {wrong.empty() ? Verdict::right : Verdict::silent, wrong};
}

std::string toText(const std::map<std::string, std::map<Verdict, int>>& counts) {
    std::string text;
    for (const auto& [format, verdicts] : counts) {
        text += format + ":";
        for (const auto& [verdict, count] : verdicts) {
            text += " " + std::to_string(count) + " " + kVerdicts.at(verdict);
        }
        text += "\n";
    }
    return text;
}

TEST(FormatCorners, EveryFileIsReadRightOrRefusedByName) {
    const test::TemporaryFolder folder;
    const std::string script = "/usr/bin/python3 -B '" KERF_SOURCE_DIR
                               "/tests/app/import/format_corners' '" +
                               folder.path().string() + "'";
    ASSERT_EQ(std::system(script.c_str()), 0);
    const Json rows = Json::parse(readBytes(folder / "corners.json"));
    std::map<std::string, std::map<Verdict, int>> counts;
    for (const Json& row : rows) {
        const std::string name = row["file"];
        const Judgement judgement = judgementOf(row, folder / name);
        ++counts[name.substr(name.rfind('.') + 1)][judgement.verdict];
        EXPECT_LE(judgement.verdict, Verdict::refused)
            << name << " is " << kVerdicts.at(judgement.verdict) << ": " << judgement.why;
    }
    std::cout << toText(counts);
    EXPECT_EQ(counts.size(), 13U);
    EXPECT_GE(rows.size(), 900U);
}

UnitGuess guessOf(const char* file, double length) {
    Bounds bounds{Vec3(5, 5, 5), Vec3(5 + 0.5 * length, 5 + length, 5 + 0.2 * length)};
    return guessUnits(file, bounds, std::nullopt);
}

TEST(UnitGuess, FollowsTheFormat) {
    EXPECT_EQ(guessOf("a.GLB", 9.66).unit, LengthUnit::metre);
    EXPECT_TRUE(guessOf("a.gltf", 0.001).certain);
    EXPECT_EQ(guessOf("a.stl", 60).unit, LengthUnit::millimetre);
    EXPECT_EQ(guessOf("a.stl", 60).up, UpAxis::z);
    EXPECT_EQ(guessOf("a.obj", 1.2).unit, LengthUnit::metre);
    EXPECT_EQ(guessOf("a.obj", 1.2).up, UpAxis::y);
    EXPECT_FALSE(guessOf("a.obj", 1.2).certain);
}

TEST(UnitGuess, TakesAnotherUnitWhereTheUsualOneMakesItTinyOrHuge) {
    EXPECT_EQ(guessOf("a.obj", 9.66).unit, LengthUnit::centimetre);
    EXPECT_EQ(guessOf("a.ply", 1200).unit, LengthUnit::millimetre);
    EXPECT_EQ(guessOf("a.stl", 0.92).unit, LengthUnit::metre);
    EXPECT_EQ(guessOf("a.obj", 1e-3).unit, LengthUnit::metre);  // There is no better one.
}

TEST(UnitGuess, SaysWhatWasTakenAndWhy) {
    EXPECT_EQ(guessOf("a.glb", 2).sentence, "glTF is in metres with +y up: 2 m long.");
    EXPECT_EQ(guessOf("a.stl", 60).sentence,
              "STL has no unit: assumed millimetres with +z up, 6 cm long.");
    EXPECT_EQ(guessOf("a.obj", 9.66).sentence,
              "OBJ has no unit: assumed centimetres with +y up, 9.66 cm long, since 9.66 m would "
              "be huge.");
    Bounds bounds{Vec3(0, 0, 0), Vec3(1, 2, 1)};
    EXPECT_EQ(guessUnits("a.fbx", bounds, FileUnits{LengthUnit::metre, UpAxis::minusZ}).sentence,
              "FBX is in metres with -z up: 2 m long.");
    EXPECT_NE(guessOf("a.stl", 0.92).sentence.find("since 920 \u00b5m would be tiny."),
              std::string::npos);
}

TEST(Standing, PutsAModelOverTheGroundWithoutScalingIt) {
    const std::vector<Vec3> own{Vec3(100, -50, 30), Vec3(160, 30, 30)};
    UnitGuess guess;
    const Placement placement = standing(guess, own);
    const Vec3 low = placement.apply(own[0]);
    const Vec3 high = placement.apply(own[1]);
    EXPECT_NEAR((high - low).norm(), 100, 1e-12);
    EXPECT_NEAR(low.y(), 2, 1e-12);
    EXPECT_NEAR((low + high).x(), 0, 1e-12);
    EXPECT_NEAR((low + high).z(), 0, 1e-12);

    Placement turned = placement;
    turned.rotate = {0, 0, 90};
    const Placement moved = standing(turned, own, Vec3(7, 1, 8));
    EXPECT_NEAR(std::min(moved.apply(own[0]).y(), moved.apply(own[1]).y()), 3, 1e-12);
    EXPECT_NEAR(0.5 * (moved.apply(own[0]) + moved.apply(own[1])).x(), 7, 1e-12);
}

}  // namespace
}  // namespace kerf::app
