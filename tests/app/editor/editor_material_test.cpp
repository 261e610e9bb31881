// Materials in the editor: chosen by name, taken back, saved and opened as files.
#include <gmock/gmock.h>

#include "app/scene/document/rest_of_body.h"
#include "app/scene/editor_scene.h"
#include "app/scene/timeline/scene_recorder.h"
#include "app/session/material.h"
#include "sim/run/simulation.h"
#include "tests/app/editor/editor_fixture.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;

/// Materials of one's own lie in a folder of the test.
class EditorMaterialTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        if (!editor->itemRects().contains("model.material")) {
            click("section.model");
        }
    }
    EditorOptions options() override {
        EditorOptions options = EditorTest::options();
        options.width = 1280;
        options.height = 1200;
        options.materials = folder / "own";
        return options;
    }
    const Params& params() { return editor->scene()->simulation().params(); }
    /// The label of what the body is made of; empty for own values.
    std::string shown() {
        const int number = panels().model.models[0].material;
        return number < 0 ? "" : panels().model.materials[number].label;
    }
    void choose(const std::string& label) {
        click("model.material");
        click("material." + label);
        frames(2);
    }
    /// Saves the values as they are under a name.
    void save(const std::string& name) {
        click("model.material");
        click("material.save");
        tap(Key::a, {.control = true});
        type(name);
        tap(Key::enter);
        waitForWork();
        frames(2);
    }
};

TEST_F(EditorMaterialTest, AChoiceSetsValuesAndLookAndIsOneChange) {
    const Params before = params();
    const render::ChosenColors ownColors = panels().display.colors;
    EXPECT_EQ(shown(), "");
    choose("Liver");
    EXPECT_TRUE(isMadeOf(params(), findMaterial("liver", {})));
    EXPECT_EQ(shown(), "Liver");
    EXPECT_EQ(panels().display.colors, findMaterial("liver", {}).colors);
    ASSERT_EQ(panels().changes.done, 1U);
    EXPECT_EQ(panels().changes.rows[0].name, "Material: Liver");
    tap(Key::z, {.control = true});
    EXPECT_EQ(params(), before);
    EXPECT_EQ(shown(), "");
    EXPECT_EQ(panels().display.colors, ownColors);
    tap(Key::z, {.shift = true, .control = true});
    EXPECT_EQ(shown(), "Liver");
    EXPECT_EQ(panels().display.colors, findMaterial("liver", {}).colors);
}

TEST_F(EditorMaterialTest, TooltipTellsValuesSpreadAndSources) {
    for (const ui::MaterialRow& row : panels().model.materials) {
        EXPECT_FALSE(row.own) << row.label;
        EXPECT_THAT(row.tooltip, HasSubstr("Young's modulus: ")) << row.label;
    }
    choose("Kidney");
    const std::string& tooltip =
        panels().model.materials[panels().model.models[0].material].tooltip;
    EXPECT_THAT(tooltip, HasSubstr("Young's modulus: 5.43 kPa (4.92 to 5.94)\n"));
    EXPECT_THAT(tooltip, HasSubstr("Toughness: 160 J/m^2, an estimate\n"));
    EXPECT_THAT(tooltip, HasSubstr("\nSources:\nAmador, Urban, Chen, Greenleaf (2011)"));
}

TEST_F(EditorMaterialTest, AnotherValueMakesItOwnValues) {
    choose("Gelatin");
    editor->scene()->execute(SetParam{"friction", 0.9});
    frames(2);
    EXPECT_EQ(shown(), "");
}

TEST_F(EditorMaterialTest, IsSavedAsAFileThatStandsInTheList) {
    choose("Gelatin");
    editor->scene()->execute(SetParam{"youngs_modulus", 23456.0});
    frames(2);
    save("stiff gel");
    const Material saved = readMaterial(folder / "own" / "stiff gel.material.json");
    EXPECT_TRUE(isMadeOf(params(), saved));
    EXPECT_EQ(saved.colors, panels().display.colors);
    EXPECT_EQ(shown(), "stiff gel");
    EXPECT_TRUE(panels().model.materials.back().own);
    choose("Rubber");
    choose("stiff gel");
    EXPECT_EQ(params().youngsModulus, 23456);
}

TEST_F(EditorMaterialTest, AFileThatIsDroppedIsTakenAtOnce) {
    test::writeText(folder / "cork.material.json",
                    R"({"format": "kerf-material", "version": 1, "label": "Cork",
                        "density": {"value": 240}})");
    editor->post(ui::FileDrop{{folder / "cork.material.json"}});
    frames(3);
    EXPECT_EQ(params().density, 240);
    EXPECT_EQ(shown(), "Cork");
    EXPECT_EQ(panels().name, "ball");
}

TEST_F(EditorMaterialTest, ABadFileIsASentenceAndChangesNothing) {
    const Params before = params();
    test::writeText(folder / "lead.material.json",
                    R"({"format": "kerf-material", "version": 1, "density": {"value": 1e9}})");
    editor->post(ui::FileDrop{{folder / "lead.material.json"}});
    frames(3);
    EXPECT_EQ(panels().toast.text,
              "lead.material.json: density.value: 1e+09 is out of range (10 to 20000).");
    EXPECT_EQ(params(), before);
}

TEST_F(EditorMaterialTest, ASavedSessionHasTheMaterialInItsEvents) {
    choose("Fat");
    editor->scene()->step();
    const Session session =
        editor->scene()
            ->recorder()
            .savedSession(editor->scene()->rest().homeView(), panels().display.colors)
            .session;
    const Session again = parseSession(formatSession(session), folder.path());
    EXPECT_EQ(again.colors, findMaterial("fat", {}).colors);
    int sets = 0;
    for (const SessionEvent& event : again.events) {
        const auto* set = std::get_if<SetParam>(&event.action);
        sets += set != nullptr && set->material == "Fat" ? 1 : 0;
    }
    EXPECT_EQ(sets, 7) << "four as before, toughness and strength, and that it has no skin";
}

}  // namespace
}  // namespace kerf::app
