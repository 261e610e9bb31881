// What the editor does where memory does not do, and how it places large models.

#include <new>

#include "app/editor/editor_state.h"
#include "gpu/buffer.h"

namespace kerf::app {
namespace {

class EditorMemoryTest : public EditorTest {
  protected:
    void TearDown() override {
        ::unsetenv("KERF_MEMORY_BYTES");
        EditorTest::TearDown();
    }
};

TEST_F(EditorMemoryTest, AModelBeyondTheMeansOfTheMachineIsSaidAndChangesNothing) {
    writeText(folder / "box.obj", objText(boxSoup(Vec3::Ones(), 4)));
    for (const char* bytes : {"0", "1000", "100000"}) {
        ::setenv("KERF_MEMORY_BYTES", bytes, 1);
        open(folder / "box.obj");
        EXPECT_THAT(panels().toast.text, HasSubstr("box.obj: cutting it needs about")) << bytes;
        EXPECT_TRUE(panels().toast.isError);
        EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    }
    ::unsetenv("KERF_MEMORY_BYTES");
    open(folder / "box.obj");
    EXPECT_EQ(editor->title(), "Kerf - box - 1 piece");
}

TEST_F(EditorMemoryTest, ASessionOfSeveralModelsIsCountedAsAWhole) {
    const MemoryNeed one = memoryNeedOf(openDocument(builtinModelFile("sphere80")));
    const std::string bytes = std::to_string(3 * (one.memory + one.graphics) / 2);
    ::setenv("KERF_MEMORY_BYTES", bytes.c_str(), 1);
    open(builtinModelFile("sphere80"));
    ASSERT_EQ(editor->title(), "Kerf - sphere80 - 1 piece");
    writeText(folder / "two.kerf.json", R"({"format": "kerf-session", "version": 1,
        "model": {"builtin": "sphere80"}, "more_models": [
            {"builtin": "sphere80", "placement": {"translate": [3, 0, 0]}}],
        "steps": 1, "events": []})");
    openAtStart(folder / "two.kerf.json");
    EXPECT_TRUE(panels().toast.isError) << panels().toast.text;
    EXPECT_EQ(editor->title(), "Kerf - sphere80 - 1 piece");
}

class EditorOutOfMemoryTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        EditorOptions options = plainOptions();
        options.journals = folder.path();
        state.emplace(options);
        state->show(UploadedDocument(prepareDocument(sphereDocument())));
        frames(2);
    }
    void TearDown() override {
        state.reset();
        GlTest::TearDown();
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            state->sparingly([&] { state->makePicture(kFrameSeconds); });
        }
    }
    template <class Exception>
    void runOutOfMemory(const Exception& exception) {
        state->scene.begin(SceneWork::change, [exception](EditorScene&) { throw exception; });
        frames(1);
    }
    void waitForQuestion() {
        for (int i = 0; i < 2000 && !state->panels.asked; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            frames(1);
        }
    }

    test::TemporaryFolder folder;
    std::optional<Editor::State> state;
};

TEST_F(EditorOutOfMemoryTest, WhatWasDoneIsKeptAndOfferedAtOnce) {
    ASSERT_EQ(state->scene->execute(SetParam{"friction", 0.25}), "");
    frames(3);
    runOutOfMemory(std::bad_alloc());
    EXPECT_TRUE(state->scene == nullptr);
    EXPECT_EQ(state->title(), "Kerf");
    frames(1);
    EXPECT_THAT(state->panels.model.toast.text, HasSubstr("ran out of memory"));
    EXPECT_THAT(state->panels.model.toast.text, HasSubstr("Your work was saved for recovery."));
    waitForQuestion();
    ASSERT_TRUE(state->panels.asked);
    state->answer(ui::AnswerQuestion{kGoOn});
    for (int i = 0; i < 4000 && state->scene == nullptr; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        frames(1);
    }
    frames(10);
    ASSERT_FALSE(state->scene == nullptr);
    EXPECT_EQ(state->scene->simulation().params().friction, 0.25);
}

TEST_F(EditorOutOfMemoryTest, ADriverWithoutMemoryIsToldInItsOwnWords) {
    runOutOfMemory(gpu::OutOfMemory("No memory left for a buffer."));
    EXPECT_TRUE(state->scene == nullptr);
    frames(1);
    EXPECT_EQ(state->panels.model.toast.text, "No memory left for a buffer.");
    state->show(UploadedDocument(prepareDocument(sphereDocument())));
    frames(2);
    EXPECT_EQ(state->title(), "Kerf - ball - 1 piece") << "another model can be opened";
}

TEST_F(EditorMemoryTest, WhereBuffersAreTooSmallForImplicitStepsTheSolverIsPbd) {
    writeText(folder / "ball.obj", objText(icosphereSoup(2)));
    const Document model = openDocument(folder / "ball.obj");
    MemoryMeans means{.free = MemoryMeans::kNoLimit,
                      .largestBuffer = memoryNeedOf(model).largestBuffer};
    EXPECT_EQ(prepareDocument(model, nullptr, means).document.session.params.solver,
              SolverMode::implicit);
    --means.largestBuffer;
    const Document fitted = prepareDocument(model, nullptr, means).document;
    EXPECT_EQ(fitted.session.params.solver, SolverMode::pbd);
    EXPECT_LT(fitted.session.params.timeStep, model.session.params.timeStep);
    EXPECT_THAT(fitted.note, HasSubstr("so its solver is pbd, with smaller steps."));
    Document session = model;
    session.guess.reset();
    EXPECT_THROW(prepareDocument(session, nullptr, means), MemoryShortage) << "keeps its bits";
    means.largestBuffer = 1;
    EXPECT_THROW(prepareDocument(model, nullptr, means), MemoryShortage);
}

/// A model that is too large to follow its placement at once.
class EditorPlacingTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        editor->resize(1280, 1200);
        writeText(folder / "large.obj", objText(boxSoup(Vec3::Ones(), 45)));
        open(folder / "large.obj", 2);
        ASSERT_GT(panels().body.triangles, 20'000);
    }
    LengthUnit unit() const { return panels().model.models[0].placement.unit.value(); }
    Simulation& simulation() { return editor->scene()->simulation(); }
};

TEST_F(EditorPlacingTest, ALargeModelIsPlacedBehindTheScene) {
    ASSERT_EQ(unit(), LengthUnit::metre);
    const std::string before = simulation().stateHash();
    clickAndWait("model.unit.cm");
    EXPECT_EQ(unit(), LengthUnit::centimetre);
    EXPECT_NEAR(panels().model.models[0].size.y(), 0.01, 1e-6);
    const std::string placed = simulation().stateHash();
    const Placement where = simulation().placement();
    tap(Key::z, {.control = true});
    EXPECT_EQ(simulation().stateHash(), before);
    EXPECT_EQ(editor->scene()->execute(Place{where, false, 0}), "") << "at once";
    EXPECT_EQ(simulation().stateHash(), placed) << "with the same bits";
    tap(Key::z, {.control = true});
    EXPECT_EQ(simulation().stateHash(), before);
}

TEST_F(EditorPlacingTest, CancelLeavesItWhereItIs) {
    const std::string before = simulation().stateHash();
    const ui::Rect item = editor->itemRects().at("model.unit.cm");
    moveTo(item.x + item.width / 2, item.y + item.height / 2);
    press(true);
    press(false);
    for (int i = 0; i < 5 && !editor->working(); ++i) {
        frames(1);
    }
    tap(Key::escape);  // in the next picture, which would take what the thread has made
    EXPECT_FALSE(editor->working());
    frames(2);
    EXPECT_EQ(unit(), LengthUnit::metre);
    EXPECT_EQ(simulation().stateHash(), before);
}

TEST_F(EditorPlacingTest, AnotherModelTakesThePlaceOfWhatIsBeingPlaced) {
    click("model.unit.cm");
    writeText(folder / "box.obj", objText(boxSoup()));
    open(folder / "box.obj");
    EXPECT_EQ(editor->title(), "Kerf - box - 1 piece");
    EXPECT_EQ(unit(), LengthUnit::metre);
}

}  // namespace
}  // namespace kerf::app
