// kerf materials, and kerf replay --material.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "app/session/material.h"
#include "tests/support/run_kerf.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using nlohmann::json;
using test::ProgramRun;
using test::runKerf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(MaterialsVerb, ListsALineForEach) {
    const ProgramRun run = runKerf({"materials"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    for (const std::string& name : app::materialNames()) {
        EXPECT_THAT("\n" + run.out, HasSubstr("\n" + name + " ")) << name;
    }
    EXPECT_EQ(std::ranges::count(run.out, '\n'), std::ssize(app::materialNames()));
}

TEST(MaterialsVerb, ShowsOneWithItsSpreadAndSources) {
    const ProgramRun run = runKerf({"materials", "liver"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_THAT(run.out, StartsWith("Liver: "));
    EXPECT_THAT(run.out, HasSubstr("\nYoung's modulus: 5.4 kPa (4.2 to 6.6)\n    Physics in"));
    EXPECT_THAT(run.out, HasSubstr("\nFriction: 0.3, an estimate\n    Estimate: "));
    EXPECT_THAT(run.out, HasSubstr("\nToughness: 164 J/m^2 (76 to 225)\n"));
    EXPECT_THAT(run.out, HasSubstr("\nTensile strength: 50 kPa (36 to 55.3)\n    Dunford"));
    EXPECT_THAT(run.out, Not(HasSubstr("Skin")));
    EXPECT_THAT(runKerf({"materials", "banana"}).out,
                HasSubstr("\nSkin tensile strength: 300 kPa, an estimate\n"));
}

TEST(MaterialsVerb, HasJsonAsInFiles) {
    const ProgramRun all = runKerf({"materials", "--json"});
    ASSERT_EQ(all.exitCode, 0) << all.errors;
    const json list = json::parse(all.out).at("materials");
    EXPECT_EQ(list.size(), app::materialNames().size());
    const ProgramRun one = runKerf({"materials", "brain", "--json"});
    ASSERT_EQ(one.exitCode, 0) << one.errors;
    json brain = json::parse(one.out);
    EXPECT_TRUE(std::ranges::find(list, brain) != list.end());
    EXPECT_EQ(brain.at("name"), "brain");
    EXPECT_EQ(brain.at("format"), "kerf-material");
}

TEST(MaterialsVerb, RefusesWhatIsNoMaterial) {
    const ProgramRun unknown = runKerf({"materials", "adamant"});
    EXPECT_EQ(unknown.exitCode, 3);
    EXPECT_THAT(unknown.errors, HasSubstr("there is no material 'adamant'; there are agar, "));
    const test::TemporaryFolder folder;
    test::writeText(folder / "bad.json", "{}");
    const ProgramRun bad = runKerf({"materials", folder / "bad.json"});
    EXPECT_EQ(bad.exitCode, 3);
    EXPECT_THAT(bad.errors, HasSubstr("bad.json: format: this key is missing"));
}

TEST(ReplayMaterial, SetsTheSameAsItsValuesAndAsTheKeyInTheSession) {
    const test::TemporaryFolder folder;
    const std::string head = R"({"format": "kerf-session", "version": 1, "steps": 3,
        "model": {"builtin": "sphere20"}, "params": {"floor": -0.4})";
    test::writeText(folder / "plain.kerf.json", head + "}");
    test::writeText(folder / "named.kerf.json", head + R"(, "material": "tofu"})");
    const auto hashOf = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--out", (folder / "out").string(), "--json"});
        const ProgramRun run = runKerf(arguments);
        EXPECT_EQ(run.exitCode, 0) << run.errors;
        return json::parse(run.out).at("state_hash").get<std::string>();
    };
    const std::string plain = folder / "plain.kerf.json";
    const std::string named = folder / "named.kerf.json";
    const app::Material tofu = app::findMaterial("tofu", {});
    std::vector<std::string> byValues{"replay", plain};
    for (const SetParam& set : app::settingsOf(tofu)) {
        byValues.insert(byValues.end(),
                        {"--set", set.name + "=" + json(std::get<double>(set.value)).dump()});
    }
    const std::string expected = hashOf(byValues);
    EXPECT_EQ(hashOf({"replay", named}), expected);
    EXPECT_EQ(hashOf({"replay", plain, "--material", "tofu"}), expected);
    EXPECT_NE(hashOf({"replay", plain}), expected);
    const ProgramRun unknown =
        runKerf({"replay", plain, "--out", folder / "no", "--material", "adamant"});
    EXPECT_EQ(unknown.exitCode, 3);
    EXPECT_FALSE(std::filesystem::exists(folder / "no"));
}

}  // namespace
}  // namespace kerf
