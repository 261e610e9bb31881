#pragma once

#include "app/practice/score.h"
#include "app/scene/editor_scene.h"
#include "app/scene/readout/surface_anchor.h"
#include "app/session/session.h"
#include "app/tools/view_frame.h"
#include "sim/base/stopwatch.h"
#include "ui/base/settings.h"
#include "ui/state/overlay.h"
#include "ui/state/window_state.h"

namespace kerf {
struct UncutBody;
}

namespace kerf::app {

/// The task of the open session: its lines on the body, the expert's blade, one's own last try, and
/// once the try is finished its score, and both blades together. Nothing without a task.
class Practice {
  public:
    /// Finished tries are kept in `folder`; empty keeps none.
    explicit Practice(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Follows the open scene once a picture, where it rests. Returns whether it shows something
    /// else.
    bool follow(EditorScene& scene, const ui::Settings& settings);
    /// Finishes the try as soon as the blade has cut its way.
    void finish() { finishing_ = true; }
    /// Whether that is so now.
    bool isDue(const EditorScene& scene) const;
    /// Scores the try, and keeps it. Returns "" or one sentence.
    std::string judge(EditorScene& scene, Session played, const std::string& person);

    /// The task of the open scene has changed, perhaps with what is to be spared.
    void change(const Document& document, bool spares);
    /// A try with its score.
    struct ScoredTry {
        Session session;
        Score score;
    };
    /// The last one that passed, since the task was opened or changed.
    const std::optional<ScoredTry>& passed() const { return passed_; }

    void addTo(ui::Overlay& overlay, const ViewFrame& view, const ui::Settings& settings) const;
    void describe(ui::PracticeState& state) const;
    bool isScored() const { return score_.has_value(); }

  private:
    /// A line of the world [m].
    struct WorldTrace {
        ui::Overlay::Trace::Kind kind;
        Vec3 from;
        Vec3 to;
        Vec3 normal = Vec3::Zero();  ///< of the skin there; it hides what faces away
    };
    /// A try by another hand, or an earlier one: its poses and its figures.
    struct OtherTry {
        std::vector<HandPose> hand;
        double share = 0;                            ///< see handShare()
        std::map<std::string, std::string> figures;  ///< as text, by FigureRow::key
        std::string problem;                         ///< why less could be read, a sentence
    };
    static OtherTry readTry(const std::filesystem::path& file, const Vec3& origin,
                            const Vec3& middle);

    void open(EditorScene& scene, const std::string& person);
    void openLast(const std::string& person);
    void layLines(EditorScene& scene);
    void layLine(const std::vector<SurfaceAnchor>& anchors, const SurfaceMesh& mesh, bool closed);
    void layRim(EditorScene& scene);
    void addHand(const OtherTry& shown, ui::Overlay::Trace::Kind kind, ui::Overlay& overlay,
                 const ViewFrame& view) const;

    std::filesystem::path folder_;
    std::optional<Task> task_;
    Vec3 origin_ = Vec3::Zero();              ///< of the scene [m]
    std::shared_ptr<const UncutBody> uncut_;  ///< on which the lines were found
    std::vector<std::vector<SurfaceAnchor>> lines_;
    std::vector<std::vector<Vec3>> spared_;  ///< points of what must not be cut [m]
    std::vector<WorldTrace> traces_;         ///< on the present body
    int revision_ = -1;                      ///< of it
    OtherTry expert_;
    OtherTry last_;
    std::string lastPerson_;  ///< whose that is
    OtherTry scored_;         ///< the one that was scored: its hand
    Stopwatch watch_;         ///< of the blades that are shown
    bool cutting_ = false;
    bool finishing_ = false;
    std::optional<Score> score_;
    std::optional<ScoredTry> passed_;
    std::optional<ui::TaskDraft> draft_;
    int deeds_ = 0;  ///< of the scene that was scored
};

}  // namespace kerf::app
