// Materials: the files that come with Kerf, what a session makes of them, and bad files.
#include "app/session/material.h"

#include "tests/support/session_schema.h"

namespace kerf::app {
namespace {

/// A material with these keys behind the ones that every material needs.
std::string materialWith(const std::string& more) {
    return R"({"format": "kerf-material", "version": 1, )" + more + "}";
}

/// The sentence with which the reader refuses a text; empty where it does not.
std::string refusalOf(const std::string& text) {
    return inputErrorOf([&] { parseMaterial(text); });
}

std::string sessionRefusalOf(const std::string& text, const fs::path& folder) {
    return inputErrorOf([&] { parseSession(text, folder); });
}

Session sessionOf(const std::string& more) {
    return parseSession(sessionWith(more), "/folder");
}

TEST(BuiltinMaterials, HaveAllValuesWithinTheirSpreadAndASourceForEach) {
    ASSERT_GE(builtinMaterials().size(), 19U);
    for (const Material& material : builtinMaterials()) {
        for (const MaterialProperty& property : materialProperties()) {
            SCOPED_TRACE(material.name + ", " + property.name);
            const MaterialValue& value = material.*property.member;
            if (!value.value && std::string_view(property.name).starts_with("skin_")) {
                continue;  // few have a skin of their own
            }
            ASSERT_TRUE(value.value);
            EXPECT_LE(value.low.value_or(*value.value), *value.value);
            EXPECT_GE(value.high.value_or(*value.value), *value.value);
            EXPECT_THAT(describeSources(material, property), Not(IsEmpty()));
        }
        EXPECT_NE(material.label, "");
        EXPECT_NE(material.about, "") << material.name;
        EXPECT_TRUE(material.colors.any()) << material.name;
    }
}

TEST(BuiltinMaterials, CanBeToldApartByTheirParameters) {
    for (const Material& material : builtinMaterials()) {
        Params params;
        for (const SetParam& set : settingsOf(material)) {
            ASSERT_EQ(setParam(params, set.name, set.value), "");
        }
        for (const Material& other : builtinMaterials()) {
            EXPECT_EQ(isMadeOf(params, other), other.name == material.name)
                << material.name << " and " << other.name;
        }
    }
}

TEST(BuiltinMaterials, ReadBackFromWhatIsWritten) {
    for (const Material& material : builtinMaterials()) {
        const std::string text = formatMaterial(material);
        const Material again = parseMaterial(text);
        EXPECT_EQ(formatMaterial(again), text);
        EXPECT_EQ(describeMaterial(again), describeMaterial(material));
        EXPECT_EQ(again.colors, material.colors) << material.name;
    }
}

TEST(BuiltinMaterials, StandOnTheirPageWithValuesAndSources) {
    const std::string page = readBytes(KERF_SOURCE_DIR "/docs/materials.md");
    for (const Material& material : builtinMaterials()) {
        std::string row = "| `" + material.name + "` | ";
        row.append(Json(*material.youngsModulus.value / 1000).dump());
        if (const std::size_t zero = row.find(".0"); zero == row.size() - 2) {
            row.resize(zero);
        }
        EXPECT_THAT(page, HasSubstr(row));
        for (const MaterialSource& source : material.sources) {
            EXPECT_THAT(page, HasSubstr(source.text)) << material.name;
            EXPECT_THAT(page, HasSubstr(source.doi)) << material.name;
        }
    }
}

TEST(MaterialFile, SaysWhatIsWrongAndWhere) {
    const std::vector<std::pair<std::string, std::string>> mistakes{
        {"", "line 1, column 1: "},
        {"[]", "top level: expected an object"},
        {R"({"format": "kerf-session", "version": 1})", "format: expected \"kerf-material\""},
        {R"({"format": "kerf-material", "version": 2, "density": {"value": 9}})",
         "version: version 2 is not supported"},
        {materialWith(R"("label": "x")"), ": a material needs \"youngs_modulus\""},
        {materialWith(R"("density": 1000)"), "density: expected an object"},
        {materialWith(R"("density": {})"), "density.value: this key is missing"},
        {materialWith(R"("density": {"value": 1})"),
         "density.value: 1 is out of range (10 to 20000)"},
        {materialWith(R"("density": {"value": 900, "low": 800})"), "density: a spread needs both"},
        {materialWith(R"("density": {"value": 900, "low": 950, "high": 990})"),
         "density.low: low must not be above value."},
        {materialWith(R"("density": {"value": 900, "low": 800, "high": 850})"),
         "density.high: high must not be below value."},
        {materialWith(R"("density": {"value": 900}, "look": {"look": "velvet"})"),
         "look.look: 'velvet' is none of citrus, "},
        {materialWith(R"("density": {"value": 900}, "label": ")" + std::string(61, 'x') + "\""),
         "label: at most 60 bytes."},
        {materialWith(R"("density": {"value": 900}, "sources": [{"of": ["mass"], "text": "x"}])"),
         "sources[0].of[0]: 'mass' is none of youngs_modulus, density"},
        {materialWith(R"("density": {"value": 900}, "sources": [{"text": "x"}])"),
         "sources[0].of: this key is missing"},
    };
    for (const auto& [text, sentence] : mistakes) {
        EXPECT_THAT(refusalOf(text), StartsWith(sentence)) << text;
    }
}

TEST(MaterialFile, HasTheNameOfItsFileAndThatAsLabelWhereItHasNone) {
    const test::TemporaryFolder folder;
    writeText(folder / "my gel.material.json", materialWith(R"("density": {"value": 900})"));
    const Material material = readMaterial(folder / "my gel.material.json");
    EXPECT_EQ(material.name, "my gel");
    EXPECT_EQ(material.label, "my gel");
}

TEST(MaterialFolder, LeavesOutWhatCanNotBeReadAndSaysSo) {
    const test::TemporaryFolder folder;
    writeText(folder / "b.material.json", materialWith(R"("density": {"value": 900})"));
    writeText(folder / "a.material.json", materialWith(R"("density": {"value": 800})"));
    writeText(folder / "broken.material.json", materialWith(R"("density": {"value": 0})"));
    writeText(folder / "note.txt", "no material");
    std::vector<std::string> problems;
    std::vector<std::string> names;
    for (const Material& material : materialsIn(folder.path(), problems)) {
        names.push_back(material.name);
    }
    EXPECT_THAT(names, ElementsAre("a", "b"));
    EXPECT_THAT(problems, ElementsAre(StartsWith("broken.material.json: density.value: ")));
    problems.clear();
    EXPECT_THAT(materialsIn(folder / "nowhere", problems), IsEmpty());
    EXPECT_THAT(problems, IsEmpty());
}

TEST(SessionMaterial, GivesTheParametersThatTheSessionDoesNotSet) {
    const Session session = sessionOf(R"("params": {"density": 900}, "material": "liver")");
    const Material liver = findMaterial("liver", {});
    EXPECT_EQ(session.params.youngsModulus, *liver.youngsModulus.value);
    EXPECT_EQ(session.params.friction, *liver.friction.value);
    EXPECT_EQ(session.params.damping, *liver.damping.value);
    EXPECT_EQ(session.params.density, 900);
    Params rest = session.params;
    for (const char* name :
         {"youngs_modulus", "density", "friction", "damping", "toughness", "tensile_strength"}) {
        setParam(rest, name, getParam(Params{}, name));
    }
    EXPECT_EQ(rest, Params{});
}

TEST(SessionMaterial, GivesItsLookWhereTheViewChoosesNone) {
    const std::string camera = R"("eye": [0, 0, 3], "target": [0, 0, 0])";
    const Material liver = findMaterial("liver", {});
    EXPECT_EQ(sessionOf(R"("material": "liver")").colors, liver.colors);
    EXPECT_EQ(sessionOf(R"("material": "liver", "view": {)" + camera + "}").colors, liver.colors);
    const Session own =
        sessionOf(R"("material": "liver", "view": {"look": "wood", )" + camera + "}");
    EXPECT_EQ(own.colors.look, render::LookName::wood);
    EXPECT_FALSE(own.colors.skin);
}

TEST(SessionMaterial, IsWrittenByNameWithItsValues) {
    const Session session =
        sessionOf(R"("material": "brain", "view": {"eye": [0, 0, 3], "target": [0, 0, 0]})");
    const std::string text = formatSession(session);
    EXPECT_THAT(text, HasSubstr("\"material\": \"brain\""));
    const Session again = parseSession(text, "/folder");
    EXPECT_EQ(again.params, session.params);
    EXPECT_EQ(again.colors, session.colors);
}

TEST(SessionMaterial, LosesItsNameWhereItIsAnotherOne) {
    Session session = sessionOf(R"("material": "brain")");
    session.params.youngsModulus *= 2;
    const std::string text = formatSession(session);
    EXPECT_EQ(text.find("material"), std::string::npos);
    EXPECT_EQ(parseSession(text, "/folder").params, session.params);
    Session plain = sessionOf(R"("material": "brain")");
    plain.colors = {};
    EXPECT_EQ(parseSession(formatSession(plain), "/folder").colors, plain.colors)
        << "nor does its look come back";
}

TEST(SessionMaterial, TakesTheSkinOfTheOneBeforeAway) {
    Params params;
    applyMaterial(params, findMaterial("skin-over-fat", {}));
    EXPECT_GT(params.skinThickness, 0);
    EXPECT_GT(params.skinModulus, params.youngsModulus);
    const Params skinned = params;
    applyMaterial(params, findMaterial("liver", {}));
    EXPECT_EQ(params.skinThickness, 0);
    EXPECT_EQ(params.skinModulus, skinned.skinModulus) << "which idles";
    EXPECT_EQ(params.skinToughness, skinned.skinToughness);
    EXPECT_EQ(params.skinStrength, skinned.skinStrength);
}

TEST(SessionMaterial, TearsItsSkinByItsOwn) {
    Params params;
    applyMaterial(params, findMaterial("skin-over-fat", {}));
    const Material fat = findMaterial("fat", {});
    EXPECT_EQ(params.toughness, *fat.toughness.value) << "of the flesh";
    EXPECT_EQ(params.tensileStrength, *fat.tensileStrength.value);
    const Material skin = findMaterial("skin", {});
    EXPECT_EQ(params.skinToughness, *skin.toughness.value);
    EXPECT_EQ(params.skinStrength, *skin.tensileStrength.value);
    EXPECT_EQ(params.tearing, 0) << "no material switches it on";
}

TEST(SessionMaterial, MayBeAFileBesideTheSession) {
    const test::TemporaryFolder folder;
    writeText(folder / "gel.json", materialWith(R"("youngs_modulus": {"value": 12345})"));
    writeText(folder / "bad.json", materialWith(R"("density": {"value": "x"})"));
    const std::string name = R"("material": ")";
    const Session session = parseSession(sessionWith(name + R"(gel.json")"), folder.path());
    EXPECT_EQ(session.params.youngsModulus, 12345);
    EXPECT_EQ(session.params.density, Params{}.density);
    EXPECT_FALSE(session.colors.any());
    EXPECT_THAT(sessionRefusalOf(sessionWith(name + R"(bad.json")"), folder.path()),
                StartsWith("material: bad.json: density.value: expected a number"));
    EXPECT_THAT(sessionRefusalOf(sessionWith(name + R"(none.json")"), folder.path()),
                StartsWith("material: "));
    EXPECT_THAT(sessionRefusalOf(sessionWith(name + R"(lliver")"), folder.path()),
                StartsWith("material: there is no material 'lliver'; there are agar, apple, "));
    EXPECT_THAT(sessionRefusalOf(sessionWith(R"("material": 5)"), folder.path()),
                StartsWith("material: expected a text"));
}

TEST(MaterialSettings, OfAFurtherModelAreThoseThatItMayHaveOfItsOwn) {
    std::vector<std::string> names;
    for (const SetParam& set : settingsOf(findMaterial("fat", {}), 2)) {
        names.push_back(set.name);
    }
    EXPECT_THAT(names, ElementsAre("youngs_modulus@2", "density@2"));
}

TEST(MaterialSettings, MakeAMaterialFromTheValuesAsTheyAre) {
    Params params;
    params.youngsModulus = 7654.25;
    params.damping = 0.0125;
    const Material material = parseMaterial(formatMaterial(materialFrom(
        params, {.look = render::LookName::jelly, .skin = Vec3(0.1, 0.2, 0.3), .flesh = {}})));
    EXPECT_TRUE(isMadeOf(params, material));
    EXPECT_EQ(material.colors.look, render::LookName::jelly);
    EXPECT_EQ(material.colors.skin, Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(material.toughness.value, params.toughness);
    EXPECT_EQ(material.tensileStrength.value, params.tensileStrength);
    params.friction = 0.75;
    EXPECT_FALSE(isMadeOf(params, material));
}

TEST(MaterialSettings, MakeAMaterialOfASkinWhereThereIsOne) {
    Params params;
    Material material = materialFrom(params, {});
    EXPECT_FALSE(material.skinThickness.value);
    EXPECT_FALSE(material.skinToughness.value);
    EXPECT_EQ(formatMaterial(material).find("skin_"), std::string::npos);
    params.skinThickness = 0.002;
    params.skinStrength = 7e6;
    material = parseMaterial(formatMaterial(materialFrom(params, {})));
    EXPECT_EQ(material.skinThickness.value, 0.002);
    EXPECT_EQ(material.skinToughness.value, params.skinToughness);
    EXPECT_EQ(material.skinStrength.value, 7e6);
    EXPECT_TRUE(isMadeOf(params, material));
}

TEST(MaterialSchema, IsThatOfTheProgramAndNamesEveryKey) {
    EXPECT_EQ(schemaFile("material.schema.json", materialSchema()), materialSchema())
        << "Renew it: KERF_RENEW=1 build/kerf_app_tests --gtest_filter='*Schema*'";
    const ProgramRun run = runKerf({"schema", "material"});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_EQ(run.out, materialSchema());
    const Json schema = Json::parse(materialSchema());
    for (const Material& material : builtinMaterials()) {
        const Json written = Json::parse(formatMaterial(material));
        for (const auto& [key, value] : written.items()) {
            EXPECT_TRUE(schema["properties"].contains(key)) << key;
        }
    }
    EXPECT_EQ(schema["properties"]["density"]["properties"]["value"]["minimum"], 10);
}

}  // namespace
}  // namespace kerf::app
