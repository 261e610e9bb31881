#include "ui/state/action_table.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/paths.h"
#include "ui/state/panel_model.h"

namespace kerf::ui {
namespace {

std::vector<Shortcut> allShortcuts() {
    std::vector<Shortcut> all;
    for (const ActionRow& row : actionTable()) {
        if (row.shortcut.key != Key::none) {
            all.push_back(row.shortcut);
        }
        if (row.second.key != Key::none) {
            all.push_back(row.second);
        }
    }
    return all;
}

TEST(ActionTable, EveryKeyStandsOnce) {
    const std::vector<Shortcut> table = allShortcuts();
    for (std::size_t i = 0; i < table.size(); ++i) {
        for (std::size_t j = i + 1; j < table.size(); ++j) {
            EXPECT_FALSE(table[i].key == table[j].key && table[i].modifiers == table[j].modifiers)
                << table[i].text << " and " << table[j].text << " are one key";
        }
    }
}

TEST(ActionTable, EveryRowIsFoundByItsKeys) {
    for (const ActionRow& row : actionTable()) {
        if (row.shortcut.key != Key::none) {
            EXPECT_EQ(findAction(row.shortcut.key, row.shortcut.modifiers), row.id) << row.label;
        }
        if (row.second.key != Key::none) {
            EXPECT_EQ(findAction(row.second.key, row.second.modifiers), row.id) << row.label;
        }
    }
}

TEST(ActionTable, EveryRowSaysWhatItDoes) {
    for (const ActionRow& row : actionTable()) {
        EXPECT_EQ(row.shortcut.text.empty(), row.shortcut.key == Key::none) << row.label;
        EXPECT_EQ(row.second.text.empty(), row.second.key == Key::none) << row.label;
        EXPECT_FALSE(row.label.empty());
        EXPECT_FALSE(row.group.empty());
    }
}

TEST(ActionTable, EveryActionHasARow) {
    for (int id = 0; id < static_cast<int>(ActionId::count); ++id) {
        EXPECT_EQ(static_cast<int>(rowOf(static_cast<ActionId>(id)).id), id);
    }
}

TEST(ActionTable, RowsOfAMenuStandTogether) {
    std::vector<std::string_view> groups;
    for (const ActionRow& row : actionTable()) {
        if (groups.empty() || groups.back() != row.group) {
            groups.push_back(row.group);
        }
    }
    EXPECT_EQ(groups,
              (std::vector<std::string_view>{"File", "Edit", "Tool", "Time", "View", "Help"}));
}

TEST(ActionTable, RowsFollowTheModel) {
    PanelModel model;
    for (const ActionId id : {ActionId::openFile, ActionId::screenshot, ActionId::togglePanels,
                              ActionId::help, ActionId::quit}) {
        EXPECT_TRUE(isAvailable(model, id)) << "with nothing open: " << rowOf(id).label;
    }
    EXPECT_FALSE(isAvailable(model, ActionId::playPause));
    model.name = "ball";
    std::vector<ActionId> unavailable;
    for (const ActionRow& row : actionTable()) {
        if (!isAvailable(model, row.id)) {
            unavailable.push_back(row.id);
        }
    }
    EXPECT_EQ(unavailable,
              (std::vector{ActionId::undo, ActionId::redo, ActionId::partModel, ActionId::bringDown,
                           ActionId::freePins, ActionId::removeRetractor, ActionId::finishTry,
                           ActionId::loop, ActionId::showApart}));
    EXPECT_TRUE(isOn(model, actionOf(Tool::stroke)));
    EXPECT_FALSE(isOn(model, actionOf(Tool::pin)));
    EXPECT_FALSE(isOn(model, ActionId::quit)) << "it switches nothing";
    model.display.overlays.ispcs = true;
    EXPECT_TRUE(isOn(model, ActionId::showIspcs));
    EXPECT_FALSE(isOn(model, ActionId::showEdges));
}

TEST(ActionTable, OtherKeysAndModifiersAreFree) {
    EXPECT_EQ(findAction(Key::none, {}), std::nullopt);
    EXPECT_EQ(findAction(Key::space, {.control = true}), std::nullopt);
}

TEST(ActionTable, TheDocsHaveTheSame) {
    std::ifstream file(KERF_SOURCE_DIR "/docs/editor.md");
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_NE(text.str().find(actionsAsMarkdown()), std::string::npos)
        << "docs/editor.md needs this table:\n"
        << actionsAsMarkdown();
}

TEST(ActionTable, TheKeysThatPeopleKnow) {
    EXPECT_EQ(findAction(Key::space, {}), ActionId::playPause);
    EXPECT_EQ(findAction(Key::period, {}), ActionId::stepOnce);
    EXPECT_EQ(findAction(Key::r, {}), ActionId::reset);
    EXPECT_EQ(findAction(Key::f1, {}), ActionId::help);
    EXPECT_EQ(findAction(Key::f12, {}), ActionId::screenshot);
    EXPECT_EQ(findAction(Key::f12, {.control = true}), ActionId::sceneScreenshot);
    EXPECT_EQ(describeAction(ActionId::playPause), "Play or pause (Space)");
}

}  // namespace
}  // namespace kerf::ui
