// A person without a plan: random acts in the editor, and what must hold after each of them.
#pragma once

#include <random>

#include "app/scene/document/editor_document.h"
#include "app/scene/editor_scene.h"
#include "app/scene/timeline/scene_timeline.h"
#include "sim/base/params.h"
#include "sim/run/simulation.h"
#include "tests/app/editor/editor_fixture.h"
#include "ui/state/action_table.h"

namespace kerf::app {

inline const std::vector<std::string> kTyped{"nan",  "inf", "-inf",   "1e999", "-1",  "0", "1e-300",
                                             "1e30", "",    "0x7fff", "7",     "abc", ".", "0.02"};
inline const std::vector<std::pair<int, int>> kSizes{
    {1, 1}, {1, 300}, {300, 7}, {0, 0}, {200, 120}, {640, 360}, {960, 540}, {1280, 720}};
/// What no storm clicks on: large models, and whatever leads out of the test's folder.
inline const std::vector<std::string> kAvoided{"experiment.octopus", "experiment.banana",
                                               "experiment.sphere768", "file.place"};

/// A person without a plan.
class EditorStorm : public EditorTest {
  protected:
    // --- Chance --------------------------------------------------------------------------------

    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    bool oneIn(int count) { return below(count) == 0; }
    double share() { return std::uniform_real_distribution<double>(0, 1)(random_); }
    template <class List>
    const auto& oneOf(const List& list) {
        return list[below(static_cast<int>(list.size()))];
    }
    /// Mostly over the body, now and then anywhere, outside of the window too.
    Vec2 somewhere() {
        if (oneIn(8)) {
            return {3000 * share() - 1000, 3000 * share() - 1000};
        }
        return {(0.25 + 0.5 * share()) * width_, (0.1 + 0.8 * share()) * height_};
    }
    ui::Modifiers someModifiers() { return {.shift = oneIn(4), .control = oneIn(4)}; }

    // --- Acts ----------------------------------------------------------------------------------

    void stroke() {
        Vec2 at = somewhere();
        moveTo(at.x(), at.y());
        editor->post(ui::ButtonChange{Button::left, true, someModifiers()});
        const Vec2 to = somewhere();
        const int points = oneIn(10) ? 300 : below(12);
        for (int i = 1; i <= points; ++i) {
            const Vec2 p = at + (to - at) * i / points;
            moveTo(p.x(), p.y());
            if (oneIn(6)) {
                frames(1);
            }
        }
        if (!oneIn(4)) {
            press(false);
        }
    }
    void cutAcross() {
        drag({share() * width_, 0.02 * height_}, {share() * width_, 0.95 * height_}, 8);
        frames(4);
    }
    void pointer() {
        const Vec2 at = somewhere();
        moveTo(at.x(), at.y());
        // Presses stay in the view: what lies in the panels is clicked by its name.
        const bool inView = at.x() > 0.3 * width_ && at.x() < 0.7 * width_;
        const auto button = static_cast<Button>(below(ui::kButtons));
        editor->post(ui::ButtonChange{button, inView && oneIn(2), someModifiers()});
    }
    void wheel() { editor->post(ui::Wheel{0, oneIn(10) ? 400.0 : below(9) - 4.0}); }
    void shortcut() {
        std::vector<ui::Shortcut> all;
        for (const ui::ActionRow& row : ui::actionTable()) {
            all.push_back(row.shortcut);
            if (row.second.key != Key::none) {
                all.push_back(row.second);
            }
        }
        const ui::Shortcut& row = oneOf(all);
        const int presses = oneIn(8) ? 12 : 1;
        for (int i = 0; i < presses; ++i) {
            editor->post(ui::KeyChange{row.key, true, row.modifiers});
            editor->post(ui::KeyChange{row.key, false, {}});
        }
    }
    void undoOrRedo() {
        const bool undo = oneIn(2);
        for (int i = below(6); i >= 0; --i) {
            editor->post(ui::KeyChange{undo ? Key::z : Key::y, true, {.control = true}});
        }
    }
    void anyKey() {
        const auto key = static_cast<Key>(below(static_cast<int>(Key::count)));
        if (key == Key::backspace) {
            return;  // in a dialog it leads out of the test's folder
        }
        editor->post(ui::KeyChange{key, oneIn(2), someModifiers()});
    }
    void typeText() {
        for (const char letter : oneOf(kTyped)) {
            editor->post(ui::Character{static_cast<std::uint32_t>(letter)});
        }
        editor->post(ui::KeyChange{Key::enter, true, {}});
        editor->post(ui::KeyChange{Key::enter, false, {}});
    }
    /// A point of an item that can be clicked: under a file dialog lie others, and there a click
    /// would take a bookmark of the dialog, which leads out of the test's folder.
    std::optional<Vec2> someItem(const std::string& prefix = "") {
        const bool inDialog = panels().files.purpose != ui::FilePurpose::none;
        std::vector<Vec2> found;
        for (const auto& [name, place] : editor->itemRects()) {
            const auto avoided = [&start = name](const std::string& bad) {
                return start.starts_with(bad);
            };
            if (name.starts_with(prefix) && (!inDialog || name.starts_with("file.")) &&
                std::ranges::none_of(kAvoided, avoided)) {
                found.emplace_back(place.x + share() * place.width,
                                   place.y + share() * place.height);
            }
        }
        return found.empty() ? std::nullopt : std::optional(oneOf(found));
    }
    void clickItem() {
        if (const auto at = someItem()) {
            drag(*at, oneIn(2) ? *at : Vec2(*at + Vec2(120 * share() - 60, 20 * share() - 10)), 2);
        }
    }
    void typeIntoSlider() {
        if (const auto at = someItem("param.")) {
            moveTo(at->x(), at->y());
            editor->post(ui::ButtonChange{Button::left, true, {.control = true}});
            editor->post(ui::ButtonChange{Button::left, false, {.control = true}});
            frames(2);
            typeText();
        }
    }
    void run() { frames(below(6)); }
    void size() {
        const auto [width, height] = oneIn(3) ? oneOf(kSizes) : std::pair(640, 360);
        if (width > 0) {
            width_ = width;
            height_ = height;
        }
        editor->resize(width, height);
    }
    void displayScale() {
        editor->setScale(oneIn(3) ? static_cast<float>(0.5 + 3.5 * share()) : 1);
    }
    void drop() {
        editor->post(ui::FileDrop{{dropped_[below(static_cast<int>(dropped_.size()))]}});
        if (oneIn(2)) {
            waitForWork();
        }
    }
    void leaveDialog() {
        editor->post(ui::KeyChange{Key::escape, true, {}});
        editor->post(ui::KeyChange{Key::escape, false, {}});
    }
    void goBack() {
        if (const auto at = someItem("scrubber")) {
            drag(*at, *someItem("scrubber"), 2);
        }
    }
    void loseFocus() { editor->post(ui::FocusLost{}); }

    struct Act {
        const char* name;
        void (EditorStorm::*act)();
        int weight;
    };
    static constexpr Act kActTable[] = {
        {"stroke", &EditorStorm::stroke, 10},
        {"cut across", &EditorStorm::cutAcross, 6},
        {"pointer", &EditorStorm::pointer, 5},
        {"wheel", &EditorStorm::wheel, 2},
        {"shortcut", &EditorStorm::shortcut, 12},
        {"undo or redo", &EditorStorm::undoOrRedo, 6},
        {"any key", &EditorStorm::anyKey, 4},
        {"type", &EditorStorm::typeText, 2},
        {"click item", &EditorStorm::clickItem, 8},
        {"type into slider", &EditorStorm::typeIntoSlider, 4},
        {"run", &EditorStorm::run, 6},
        {"size", &EditorStorm::size, 2},
        {"scale", &EditorStorm::displayScale, 1},
        {"drop", &EditorStorm::drop, 1},
        {"go back", &EditorStorm::goBack, 3},
        {"lose focus", &EditorStorm::loseFocus, 1},
    };

    const Act& someAct() {
        int sum = 0;
        for (const Act& act : kActTable) {
            sum += act.weight;
        }
        int chosen = below(sum);
        const Act* act = kActTable;
        while (chosen >= act->weight) {
            chosen -= act->weight;
            ++act;
        }
        return *act;
    }

    /// In a file dialog, keys alone: a click could lead out of the test's folder.
    Act actFor(const ui::PanelModel& shown) {
        const bool asked = shown.files.purpose != ui::FilePurpose::none || shown.help.open;
        if (asked && oneIn(3)) {
            return {"leave", &EditorStorm::leaveDialog, 0};
        }
        while (true) {
            const Act& act = someAct();
            const bool points = act.act == &EditorStorm::stroke ||
                                act.act == &EditorStorm::cutAcross ||
                                act.act == &EditorStorm::pointer;
            if (!points || shown.files.purpose == ui::FilePurpose::none) {
                return act;
            }
        }
    }

    // --- Files ---------------------------------------------------------------------------------

    void writeFiles() {
        const auto put = [this](const char* name, const std::string& text) {
            test::writeText(folder / name, text);
            dropped_.push_back(folder / name);
        };
        put("ball.obj", test::objText(test::icosphereSoup(2)));
        put("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        put("noise.ply", std::string("ply\nformat binary_little_endian 1.0\n\x01\xff\x00", 35));
        put("slice.kerf.json", R"({
            "format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
            "params": {"gravity": [0, 0, 0], "iterations": 3}, "steps": 40,
            "events": [{"step": 1, "type": "blade", "a": [-2, 1.5, 0.1], "b": [2, 1.5, 0.1]},
                       {"step": 30, "type": "blade", "a": [-2, -1.5, 0.1], "b": [2, -1.5, 0.1]},
                       {"step": 31, "type": "lift"}, {"step": 35, "type": "check", "pieces": 2}]})");
        put("wrong.kerf.json", R"({"format": "kerf-session", "version": 7})");
        dropped_.push_back(folder / "not-there.stl");
        dropped_.push_back(folder.path());
    }
    // --- What must hold ------------------------------------------------------------------------

    Simulation& simulation() { return editor->scene()->simulation(); }

    void expectSound() {
        EditorScene* const scene = editor->scene();
        ASSERT_NE(scene, nullptr);
        const SurfaceMesh& mesh = simulation().mesh();
        ASSERT_EQ(checkClosedManifold(mesh), "");
        const std::size_t pieces = findPieces(mesh).pieces.size();
        ASSERT_EQ(editor->title(), "Kerf - " + scene->document().name + " - " +
                                       std::to_string(pieces) +
                                       (pieces == 1 ? " piece" : " pieces"));
        for (const ParamInfo& info : paramTable()) {
            Params params;
            ASSERT_EQ(setParam(params, info.name, getParam(simulation().params(), info.name)), "")
                << info.name;
        }
    }

    /// Lets go of everything, closes what is open and stops time.
    void calmDown() {
        editor->post(ui::FocusLost{});
        editor->resize(640, 360);
        editor->setScale(1);
        frames(2);
        for (int i = 0; i < 6; ++i) {
            tap(Key::escape);
        }
        waitForWork();
        editor->scene()->timeline().playing = false;
        editor->scene()->seek(simulation().stepCount());
        settle();
        endStroke();
    }

    /// An undo would end a stroke on its way, and a redo not resume it.
    void endStroke() {
        if (simulation().blade()) {
            goToTheEnd();
        }
        if (simulation().blade()) {
            editor->scene()->step();  // it was told to lift, but time stands
        }
    }

    void goToTheEnd() {
        if (const SessionPlayback* played = editor->scene()->timeline().playback()) {
            editor->scene()->seek(played->steps());
            settle();
        }
    }

    std::mt19937 random_;
    int width_ = kWidth;
    int height_ = kHeight;
    std::vector<std::filesystem::path> dropped_;
};

}  // namespace kerf::app
