#include "app/editor/view/first_steps.h"

#include <spdlog/fmt/fmt.h>

#include "app/scene/document/rest_of_body.h"
#include "app/scene/editor_scene.h"
#include "app/scene/editor_stroke.h"
#include "app/scene/held_hands.h"
#include "app/scene/timeline/scene_timeline.h"
#include "sim/base/text.h"
#include "sim/run/parts/step_report.h"
#include "ui/state/action_table.h"

namespace kerf::app {

using ui::ActionId;
using ui::actionOf;
using ui::Hint;

constexpr double kLately = 0.2;     // simulated time in which one advance follows another [s]
constexpr double kFarAhead = 0.01;  // of a hand, as a share of the body's diagonal

static bool isFarAhead(const EditorScene& scene) {
    return scene.hands().ahead() > kFarAhead * scene.rest().bounds().diagonal();
}

void CutWatch::follow(bool cutting, int pieces, int triangles) {
    const MeshCounts now{pieces, triangles};
    if (cutting) {
        before_ = before_.value_or(now);
        met_ = met_ || now != *before_;
        outcome_ = StrokeOutcome::none;
    } else if (before_) {
        outcome_ = outcomeOf(now);
        after_ = now;
        before_.reset();
        met_ = false;
    } else if (!(now == after_)) {
        outcome_ = StrokeOutcome::none;
    }
}

/// The outcome of the stroke that has just ended.
StrokeOutcome CutWatch::outcomeOf(const MeshCounts& now) const {
    if (now == *before_) {
        return met_ ? StrokeOutcome::none : StrokeOutcome::missed;
    }
    return now.pieces > before_->pieces ? StrokeOutcome::parted : StrokeOutcome::incised;
}

void FirstSteps::follow(const Situation& now) {
    if (now.cutting) {
        cutTool_ = now.tool;
    }
    if (now.outcome == StrokeOutcome::incised || now.outcome == StrokeOutcome::parted) {
        used_[static_cast<std::size_t>(cutTool_)] = true;
    }
    used_[static_cast<std::size_t>(now.tool)] |= now.touching;
    parted_ |= now.outcome == StrokeOutcome::parted;
    played_ |= now.playing && now.session;
    const bool falls = now.playing && !now.weightless;
    weighed_ |= falls;
    wentOn_ |= fell_ && now.cutting;
    fell_ |= falls && now.parted();
}

/// While a task runs, hints lead to its score and nowhere else: an undo would break a limit.
static Hint ofTask(const Situation& now) {
    if (now.scored && now.makesTask) {
        return {"Save the task. A try that passed goes with it as the expert's:",
                {{ActionId::saveSession, "Save"}, {ActionId::reset, "Try again"}}};
    }
    if (now.scored) {
        return {now.hasExpert ? "Your blade and the expert's, side by side."
                              : "Your blade, as you led it.",
                {{ActionId::reset, "Try again"}}};
    }
    if (now.outcome == StrokeOutcome::missed) {
        return {"The blade missed. Press on the purple line, and follow it.", {}};
    }
    if (now.cut) {
        return {"Done? Then see how well you cut:", {{ActionId::finishTry, "Finish"}}};
    }
    const bool scalpel = now.tool == ui::ToolKind::scalpel;
    return {scalpel ? "Press at one end of the purple line, and draw along it. The wheel changes "
                      "the depth meanwhile."
                    : "Lead the blade along the purple line.",
            {}};
}

Hint FirstSteps::hint(const Situation& now) const {
    if (!now.open || now.touching || now.cutting) {
        return {};
    }
    if (now.task && !now.past) {
        return ofTask(now);
    }
    if (now.playing) {
        const bool still = now.weightless && !now.session && !weighed_;
        return still ? Hint{"Gravity is off, so nothing falls.",
                            {{ActionId::toggleGravity, "Turn on gravity"}}}
                     : Hint{};
    }
    if (now.past) {
        return {
            "You are viewing an earlier step. Play to continue, or cut here to discard the later "
            "steps.",
            {{ActionId::playPause, "Play"}}};
    }
    const bool chosenSince = now.tool != cutTool_ && !hasUsed(now.tool);
    Hint after = chosenSince ? Hint{} : afterStroke(now);
    return after.text.empty() ? beforeStroke(now) : after;
}

Hint FirstSteps::afterStroke(const Situation& now) const {
    if (now.outcome == StrokeOutcome::incised && !now.refusal.empty()) {
        return {"This cut did not separate anything: " + now.refusal + ".",
                {{ActionId::undo, "Undo"}}};
    }
    if (now.parted() && !fell_) {
        return {"Cut into " + counted(now.pieces, "piece", "pieces") + ". What next?",
                {{ActionId::letFall, "Let them fall"},
                 {ActionId::showApart, "Show apart"},
                 {actionOf(ui::ToolKind::grab), "Pull one"}}};
    }
    if (now.parted() && !wentOn_ && now.tool == cutTool_) {
        return {"Drag to cut again, or:",
                {{ActionId::undo, "Undo"},
                 {ActionId::reset, "Restart"},
                 {ActionId::help, "Keyboard shortcuts"}}};
    }
    const bool unsure = !parted_ && now.tool == ui::kFirstTool;
    if (unsure && now.outcome == StrokeOutcome::missed) {
        return {
            "The blade missed the model. Drag all the way across it, from one side to the other.",
            {}};
    }
    if (unsure && now.outcome == StrokeOutcome::incised) {
        return {
            "This is an incision: the stroke began or ended on the model. To cut it in two, begin "
            "and end beside it.",
            {{ActionId::undo, "Undo"}}};
    }
    if (now.outcome == StrokeOutcome::incised && !hasUsed(ui::ToolKind::grab) &&
        !hasUsed(ui::ToolKind::retract)) {
        return {"This is an incision. You can hold it open or pull on it:",
                {{actionOf(ui::ToolKind::retract), "Hold open"},
                 {actionOf(ui::ToolKind::grab), "Pull"}}};
    }
    return {};
}

Hint FirstSteps::beforeStroke(const Situation& now) const {
    if (now.session && now.tool == ui::kFirstTool && !played_) {
        return {"Press Space to play the session, or drag all the way across the model to cut it.",
                {{ActionId::playPause, "Play"}}};
    }
    if (hasUsed(now.tool)) {
        return {};
    }
    const ui::ToolRow& tool = ui::rowOf(now.tool);
    Hint hint{std::string(tool.hint), {}};
    if (!tool.trigger.empty()) {
        hint.choices = {{ActionId::bringDown, std::string(tool.trigger)}};
    }
    return hint;
}

void NewcomerGuide::begin(const EditorScene& scene) {
    cutWatch_ = {};
    piecesAtFirst_ = scene.simulation().report().pieces;
    tip_.clear();
}

Situation NewcomerGuide::situationOf(const EditorScene* scene, const EditorView& view) const {
    Situation now;
    now.tool = view.tools.settings().tool;
    if (scene == nullptr) {
        return now;
    }
    now.open = true;
    now.playing = scene->timeline().playing;
    now.weightless = scene->simulation().params().gravity.norm() == 0;
    now.past = scene->timeline().inThePast();
    now.session = scene->timeline().playingBack() && !now.past;
    now.cutting = scene->stroke().drawing() || scene->stroke().pending() > 0;
    now.touching = view.tools.holdsBody();
    const std::optional<Task>& task = scene->document().session.task;
    now.task = task.has_value();
    now.hasExpert = task && !task->expert.empty();
    now.makesTask = scene->document().makesTask;
    now.cut = !scene->simulation().strokes().empty();
    now.pieces = scene->simulation().report().pieces;
    now.piecesAtFirst = piecesAtFirst_;
    now.outcome = cutWatch_.outcome();
    now.refusal = scene->simulation().refusalOfStroke();
    return now;
}

bool NewcomerGuide::follow(const EditorScene& scene, const EditorView& view) {
    const StrokeOutcome before = cutWatch_.outcome();
    Situation now = situationOf(&scene, view);
    cutWatch_.follow(now.cutting, now.pieces, scene.simulation().report().triangles);
    now.outcome = cutWatch_.outcome();
    firstSteps_.follow(now);
    if (now.cutting || now.touching || now.playing) {
        tip_.clear();
    }
    const StepReport& report = scene.simulation().report();
    toreAt_ = report.tear && report.tear->advanced ? report.time : toreAt_;
    return now.outcome != before;
}

std::string NewcomerGuide::whyItTears(const EditorScene& scene, const EditorView& view) const {
    const Simulation& now = scene.simulation();
    const bool pulls = !now.hands().empty() && (view.tools.holdsBody() || scene.timeline().playing);
    const bool lately = std::abs(now.report().time - toreAt_) < kLately;
    return pulls ? tearSentence(now.report(), now.params(), lately) : "";
}

ui::Hint NewcomerGuide::hint(const EditorScene* scene, const EditorView& view, bool scored) const {
    if (!tip_.empty()) {
        return {tip_, {}};
    }
    std::string told = scene != nullptr ? whyItTears(*scene, view) : "";
    if (scene != nullptr && isFarAhead(*scene)) {
        told += (told.empty() ? "" : " ") +
                fmt::format("The body follows in slow motion: the hand is {} ahead.",
                            lengthText(scene->hands().ahead()));
    }
    if (!told.empty()) {
        return {told, {}};
    }
    Situation now = situationOf(scene, view);
    now.scored = scored;
    return firstSteps_.hint(now);
}

}  // namespace kerf::app
