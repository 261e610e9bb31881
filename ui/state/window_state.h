#pragma once

#include "render/scene/image.h"
#include "ui/plots/history.h"
#include "ui/state/action.h"

namespace kerf::ui {

/// A number that a question asks for, too.
struct AskedNumber {
    std::string label;
    std::string unit;
    double value = 0;  ///< that is proposed
    double least = 0;
    double most = 0;
};

/// A choice that a user has to make before anything else; none where the text is empty.
struct Question {
    std::string title;
    std::string text;
    std::vector<std::string> choices;  ///< Enter takes the first, Esc the last
    std::shared_ptr<const render::Image> picture = nullptr;  ///< its subject; may be null
    /// It is at the lower edge of the view, which shows its subject and can be turned meanwhile.
    bool aside = false;
    std::optional<AskedNumber> number = std::nullopt;
};

/// A scene that the start page offers.
struct StartCard {
    std::string name;  ///< of its file
    std::string title;
    std::string tip;                                         ///< what to try, one sentence
    ToolKind tool = kFirstTool;                              ///< with which
    std::shared_ptr<const render::Image> picture = nullptr;  ///< null if it can't be read
};

/// The page of scenes and recent files to start from.
struct StartState {
    std::shared_ptr<const std::vector<StartCard>> cards;  ///< null while the page is closed
    bool overScene = false;                               ///< a scene is open behind it
    bool opening = false;                                 ///< something is being opened
};

/// An action that a hint offers, with its label there.
struct HintChoice {
    ActionId id{};
    std::string label;
};

/// A sentence on what to do next.
struct Hint {
    std::string text;  ///< empty for no hint
    std::vector<HintChoice> choices;
};

/// Help that is offered.
struct HelpState {
    Hint hint;
    StartState start;
    bool open = false;  ///< the page of keys
    /// What the box of commands finds besides; null while it is closed.
    std::shared_ptr<const std::vector<StartCard>> samples;
};

/// A message in the view.
struct ToastState {
    std::string text;  ///< empty for none
    bool isError = false;
    float opacity = 1;                 ///< 0 to 1, while it fades
    std::optional<HintChoice> choice;  ///< possible action
};

/// Long work in the background.
struct WorkState {
    std::string title;                          ///< "Opening ball.ply"; empty for none
    std::string stage;                          ///< "Building the constraints"
    double done = 0;                            ///< parts
    double all = 0;                             ///< parts; 0 if unknown
    bool mayEnd = true;                         ///< can be cancelled
    double seconds = 0;                         ///< since it began
    std::optional<double> left = std::nullopt;  ///< [s], estimated; none if unknown
};

/// ", about 20 s left", or ", 12 s so far" where the end is not known.
std::string timeText(const WorkState& work);

/// One of the paper's experiments: its figures beside ours.
struct ExperimentCard {
    std::string name;     ///< "sphere768", for OpenExperiment
    std::string label;    ///< "Sphere 768"
    double timeStep = 0;  ///< the paper's [s]
    int iterations = 0;   ///< the paper's
    int triangles = 0;    ///< the paper's, before the cut; 0 if unknown
    RunFigures paper;
    std::optional<RunFigures> ours;  ///< of the run that is open, or of the last one; none without
    int ourTriangles = 0;            ///< of that run, at present
    bool open = false;
};

/// A figure of a score, as text with its unit; "" where there is none.
struct ScoreRow {
    std::string figure;
    std::string now;
    std::string last;    ///< of one's own last try
    std::string expert;  ///< of the session that shows it
    std::string limit;   ///< "\u2264 2"
    bool broken = false;
};

/// The task of the open session, and the score once the try is finished.
struct PracticeState {
    std::string name;  ///< empty: the session has no task
    std::string about;
    bool hasExpert = false;
    bool hasLast = false;
    bool finished = false;
    std::vector<ScoreRow> rows;
    std::vector<std::string> violations;  ///< of the finished try; it passed without any
    std::string advice;                   ///< for the next one; "" if it passed
    std::optional<TaskDraft> draft;       ///< of a task that is being made
};

}  // namespace kerf::ui
