// The panels without a window: events in, actions out.
#include "ui/interface.h"

#include <glad/gl.h>
#include <gmock/gmock.h>

#include <set>

#include "tests/support/gl_fixture.h"
#include "ui/layout.h"

namespace kerf::ui {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;

class InterfaceTest : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        interface.emplace(1.0F);
        model.name = "ball";
        model.history = &history;
        model.pieces = {{768, 4.18, 1.0}};
        pass({});
        pass({});
    }
    void TearDown() override {
        interface.reset();
        GlTest::TearDown();
    }

    /// One pass; SetParam commands are applied, as the editor would.
    std::vector<Action> pass(const std::vector<InputEvent>& events) {
        std::vector<Action> actions = interface->pass(events, model, kWidth, kHeight, 1.0 / 60);
        for (const Action& action : actions) {
            if (const auto* set = std::get_if<SetParam>(&action)) {
                EXPECT_EQ(setParam(model.params, set->name, set->value), "");
                changed.insert(set->name);
            } else {
                asked.push_back(std::get<ActionId>(action));
            }
        }
        return actions;
    }
    void moveTo(double x, double y) { pass({PointerMove{x, y, {}}}); }
    void press(bool down) { pass({ButtonChange{Button::left, down, {}}}); }
    void click(double x, double y) {
        moveTo(x, y);
        press(true);
        press(false);
    }

    void clickOn(const std::string& item) {
        const Rect place = interface->places().at(item);
        click(place.x + place.width / 2, place.y + place.height / 2);
    }

    std::optional<Interface> interface;
    PanelModel model;
    History history;
    std::set<std::string> changed;
    std::vector<ActionId> asked;
};

TEST_F(InterfaceTest, PanelsOwnThePointerOnlyOverThemselves) {
    const Layout layout = layoutPanels(kWidth, kHeight, 1);
    for (const Rect& rect : {layout.controls, layout.plots, layout.status}) {
        moveTo(rect.x + rect.width / 2, rect.y + rect.height - 4);
        EXPECT_TRUE(interface->ownsPointer());
    }
    model.hint = "Drag across the model to cut it.";
    model.toast = "Saved.";
    for (const double y : {2.0, 60.0, 360.0, 660.0}) {
        moveTo(kWidth / 2.0, y);
        EXPECT_FALSE(interface->ownsPointer()) << y;
    }
}

TEST_F(InterfaceTest, DraggingSlidersAnswersWithCommands) {
    const Params before = model.params;
    for (const char* name : {"time_step", "iterations", "ispc_stiffness", "gravity"}) {
        pass({});
        const Rect row = interface->places().at(std::string("param.") + name);
        moveTo(row.x + 0.1 * row.width, row.y + row.height / 2);
        press(true);
        moveTo(row.x + 0.9 * row.width, row.y + row.height / 2);
        press(false);
    }
    EXPECT_THAT(changed,
                ::testing::IsSupersetOf({"time_step", "iterations", "ispc_stiffness", "gravity"}));
    EXPECT_GT(model.params.timeStep, before.timeStep);
    EXPECT_GT(model.params.iterations, before.iterations);
    EXPECT_GT(model.params.ispcStiffness, before.ispcStiffness);
}

TEST_F(InterfaceTest, TheResetMarkBringsAValueBack) {
    model.params.iterations = 35;
    pass({});
    clickOn("reset.iterations");
    EXPECT_EQ(model.params.iterations, model.startParams.iterations);
}

TEST_F(InterfaceTest, TransportButtonsAsk) {
    for (const char* name : {"Play or pause", "One step", "Back to the start"}) {
        pass({});
        clickOn(std::string("button.") + name);
    }
    EXPECT_THAT(asked,
                ::testing::ElementsAre(ActionId::playPause, ActionId::stepOnce, ActionId::reset));
}

TEST_F(InterfaceTest, DrawsTheSamePictureTwice) {
    history.framesPerSecond = {{0, 60}, {1, 58}, {2, 61}};
    history.volumePercent = {{0, 100}, {1, 99.8}, {2, 99.9}};
    history.marks = {{1, "cut"}};
    const auto draw = [&] {
        pass({});
        const gpu::Framebuffer picture(GL_RGBA8, GL_DEPTH_COMPONENT24, kWidth, kHeight);
        picture.bind();
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        interface->draw(picture);
        return picture.readColor();
    };
    const std::vector<std::uint8_t> first = draw();
    EXPECT_EQ(first, draw());
    const std::set<std::uint8_t> values(first.begin(), first.end());
    EXPECT_GT(values.size(), 50U) << "panels and text leave many shades";
}

}  // namespace
}  // namespace kerf::ui
