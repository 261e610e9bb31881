#include "ui/shortcuts.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/paths.h"

namespace kerf::ui {
namespace {

TEST(ShortcutTable, EveryKeyStandsOnce) {
    const auto table = shortcutTable();
    for (std::size_t i = 0; i < table.size(); ++i) {
        for (std::size_t j = i + 1; j < table.size(); ++j) {
            EXPECT_FALSE(table[i].key == table[j].key && table[i].modifiers == table[j].modifiers)
                << table[i].keyText << " stands for \"" << table[i].label << "\" and \""
                << table[j].label << "\"";
        }
    }
}

TEST(ShortcutTable, EveryRowIsFoundByItsKey) {
    for (const Shortcut& row : shortcutTable()) {
        EXPECT_EQ(findAction(row.key, row.modifiers), row.id) << row.keyText;
    }
}

TEST(ShortcutTable, EveryRowSaysWhatItDoes) {
    for (const Shortcut& row : shortcutTable()) {
        EXPECT_NE(row.key, Key::none);
        EXPECT_FALSE(row.keyText.empty());
        EXPECT_FALSE(row.label.empty());
        EXPECT_FALSE(row.group.empty());
    }
}

TEST(ShortcutTable, EveryActionHasARow) {
    for (int id = 0; id <= static_cast<int>(ActionId::quit); ++id) {
        EXPECT_EQ(static_cast<int>(shortcutOf(static_cast<ActionId>(id)).id), id);
    }
}

TEST(ShortcutTable, OtherKeysAndModifiersAreFree) {
    EXPECT_EQ(findAction(Key::none, {}), std::nullopt);
    EXPECT_EQ(findAction(Key::space, {.control = true}), std::nullopt);
}

TEST(ShortcutTable, TheDocsHaveTheSame) {
    std::ifstream file(KERF_SOURCE_DIR "/docs/editor.md");
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_NE(text.str().find(shortcutsAsMarkdown()), std::string::npos)
        << "docs/editor.md needs this table:\n"
        << shortcutsAsMarkdown();
}

TEST(ShortcutTable, TheKeysThatPeopleKnow) {
    EXPECT_EQ(findAction(Key::space, {}), ActionId::playPause);
    EXPECT_EQ(findAction(Key::period, {}), ActionId::stepOnce);
    EXPECT_EQ(findAction(Key::r, {}), ActionId::reset);
    EXPECT_EQ(findAction(Key::f1, {}), ActionId::help);
    EXPECT_EQ(findAction(Key::f12, {}), ActionId::screenshot);
    EXPECT_EQ(findAction(Key::f12, {.control = true}), ActionId::sceneScreenshot);
    EXPECT_EQ(describeShortcut(ActionId::playPause), "Play or pause (Space)");
}

}  // namespace
}  // namespace kerf::ui
