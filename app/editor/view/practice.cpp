#include "app/editor/view/practice.h"

#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>

#include <cctype>
#include <ctime>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/practice/advice.h"
#include "app/scene/document/editor_document.h"
#include "app/scene/editor_stroke.h"
#include "app/scene/readout/scene_readout.h"
#include "app/scene/timeline/scene_recorder.h"
#include "app/session/scene_origin.h"
#include "app/session/session_json.h"
#include "app/session/task_run.h"
#include "sim/base/containers.h"
#include "sim/mesh/triangle.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {
namespace {

using Kind = ui::Overlay::Trace::Kind;

constexpr double kPointsApart = 2e-3;  // of a line on the skin [m]
constexpr int kMostPoints = 200;       // of a line
constexpr double kMostStretch = 2;     // of skin; what is farther apart was cut
constexpr int kBallPoints = 300;       // of a ball to spare
constexpr double kTrail = 0.7;         // of the expert's hand [s]
constexpr double kPause = 1.5;         // before the expert begins again [s]
constexpr std::uintmax_t kMostScoreBytes = 1 << 20;

/// How the files of a person's tries begin, in letters that any file system takes.
std::string fileNameOf(const std::string& task, const std::string& person) {
    const auto plain = [](std::string name) {
        std::ranges::replace_if(
            name, [](unsigned char c) { return c < 0x80 && std::isalnum(c) == 0; }, '-');
        return name;
    };
    return plain(task) + "_" + plain(person) + "_";
}

/// Anchors along a line of the task, where a ray along `into` meets the uncut body.
std::vector<SurfaceAnchor> anchorsOf(const Task& task, const TaskLine& line,
                                     const SurfaceMesh& uncut, const std::vector<int>& body) {
    std::vector<SurfaceAnchor> anchors;
    const Vec3 into = task.into.normalized();
    const double above = meshBounds(uncut).diagonal();
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < count; ++i) {
        const Vec3 way = line.points[(i + 1) % count] - line.points[i];
        const int parts = std::clamp(int(std::ceil(way.norm() / kPointsApart)), 1, kMostPoints);
        for (int k = 0; k < parts + (i + 2 == count && !line.closed ? 1 : 0); ++k) {
            const Vec3 point = line.points[i] + double(k) / parts * way;
            if (const auto hit = pickSurface(uncut, body, {point - above * into, into})) {
                anchors.emplace_back(uncut, *hit);
            }
        }
    }
    return anchors;
}

std::vector<Vec3> pointsOf(const Region& region) {
    std::vector<Vec3> points;
    if (const auto* ball = std::get_if<Ball>(&region)) {
        for (int i = 0; i < kBallPoints; ++i) {  // a Fibonacci spiral
            const double z = 1 - (2 * i + 1.0) / kBallPoints;
            const double turn = 2.399963 * i;
            const double r = std::sqrt(1 - z * z);
            points.push_back(ball->center +
                             ball->radius * Vec3(r * std::cos(turn), r * std::sin(turn), z));
        }
    } else {
        const Bounds& box = std::get<Bounds>(region);
        for (int corner = 0; corner < 8; ++corner) {
            points.emplace_back((corner & 1 ? box.high : box.low).x(),
                                (corner & 2 ? box.high : box.low).y(),
                                (corner & 4 ? box.high : box.low).z());
        }
    }
    return points;
}

/// The convex outline of points, counter-clockwise: Andrew's monotone chain.
std::vector<ui::PlotPoint> outlineOf(std::vector<ui::PlotPoint> points) {
    const auto byX = [](const auto& p, const auto& q) {
        return std::pair(p.x, p.y) < std::pair(q.x, q.y);
    };
    std::ranges::sort(points, byX);
    std::vector<ui::PlotPoint> outline;
    const auto walk = [&](auto begin, auto end) {
        const std::size_t from = outline.size();
        for (auto p = begin; p != end; ++p) {
            while (outline.size() > from + 1) {
                const auto& a = outline[outline.size() - 2];
                const auto& b = outline.back();
                if ((b.x - a.x) * (p->y - a.y) - (b.y - a.y) * (p->x - a.x) > 0) break;
                outline.pop_back();
            }
            outline.push_back(*p);
        }
        outline.pop_back();  // It begins the other half.
    };
    if (points.size() > 2) {
        walk(points.begin(), points.end());
        walk(points.rbegin(), points.rend());
    }
    return outline;
}

/// The pose of a hand at a time; none between strokes.
std::optional<Blade> poseAt(const std::vector<HandPose>& hand, double time) {
    const auto next = std::ranges::upper_bound(hand, time, {}, &HandPose::time);
    if (next == hand.begin() || next == hand.end() || next->begins) {
        return std::nullopt;
    }
    const HandPose& before = *std::prev(next);
    return interpolate(before.blade, next->blade,
                       (time - before.time) / (next->time - before.time));
}

std::string textOf(const FigureRow& row, const nlohmann::json& score) {
    const auto value = score.value(row.key, nlohmann::json());
    if (value.is_boolean()) {
        return formatFigure(row.unit, double(value.get<bool>()));
    }
    return value.is_number() ? formatFigure(row.unit, value.get<double>()) : "";
}

/// What a teacher sets of it.
ui::TaskDraft draftOf(const Task& task, const Document& document) {
    ui::TaskDraft draft{task.name,
                        task.about,
                        task.depth.value_or(0),
                        task.limits.deviation.value_or(0),
                        task.limits.seconds.value_or(0),
                        document.restBounds.diagonal(),
                        {}};
    const std::vector<FurtherModel>& more = document.session.moreModels;
    for (int model = 0; model <= int(more.size()); ++model) {
        if (model != task.model) {
            const ModelReference& of = model == 0 ? document.session.model : more[model - 1].model;
            draft.models.push_back({of.name(), model, std::ranges::count(task.spare, model) > 0});
        }
    }
    return draft;
}

/// The figures of a score as text, by key.
std::map<std::string, std::string> textsOf(const nlohmann::json& score) {
    std::map<std::string, std::string> texts;
    for (const FigureRow& row : figureRows()) {
        texts[row.key] = score.is_object() ? textOf(row, score) : "";
    }
    return texts;
}

void addLines(Kind kind, const Vec3& from, const Vec3& to, const ViewFrame& view,
              ui::Overlay& overlay) {
    std::vector<ui::Overlay::Line> lines;
    view.addLine(from, to, lines);
    for (const ui::Overlay::Line& line : lines) {
        overlay.traces.push_back({kind, line});
    }
}

}  // namespace

Practice::OtherTry Practice::readTry(const std::filesystem::path& file, const Vec3& origin,
                                     const Vec3& middle) {
    OtherTry read;
    try {
        read.hand = handOf(withOrigin(readSession(file), origin));
        read.share = handShare(read.hand, middle);
        read.figures = textsOf(parseJson(readInputFile(scoreFileOf(file), kMostScoreBytes)));
    } catch (const InputError& error) {  // A copy may lie alone: then less is shown.
        read.problem = error.what();
    }
    return read;
}

void Practice::openLast(const std::string& person) {
    lastPerson_ = person;
    last_ = {};
    const std::string begin = fileNameOf(task_->name, person);
    std::string newest;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, none)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(begin) && name.ends_with(kSessionEnding)) {
            newest = std::max(newest, name);
        }
    }
    if (!newest.empty()) {
        last_ = readTry(folder_ / newest, origin_, pivotOf(*task_, uncut_->mesh));
    }
}

void Practice::open(EditorScene& scene, const std::string& person) {
    task_ = scene.document().session.task;
    origin_ = scene.document().session.origin;
    uncut_ = scene.simulation().uncut();
    lines_.clear();
    spared_.clear();
    traces_.clear();
    revision_ = -1;
    score_.reset();
    passed_.reset();
    draft_.reset();
    finishing_ = false;
    watch_.restart();
    if (!task_) {
        return;
    }
    scene.simulation().feelBlade(true);
    if (scene.document().makesTask) {
        draft_ = draftOf(*task_, scene.document());
    }
    std::vector<int> body;
    for (const int model : task_->spare) {
        spared_.emplace_back();
        for (int v = 0; v < uncut_->mesh.vertexCount(); ++v) {
            if (uncut_->modelOf(v) == model) {
                spared_.back().push_back(uncut_->mesh.restPosition(v));
            }
        }
    }
    std::ranges::copy_if(livingTriangles(uncut_->mesh), std::back_inserter(body), [&](int t) {
        return uncut_->modelOf(uncut_->mesh.triangle(t)[0]) == task_->model;
    });
    for (const TaskLine& line : task_->lines) {
        lines_.push_back(anchorsOf(*task_, line, uncut_->mesh, body));
    }
    std::ranges::transform(task_->spareRegions, std::back_inserter(spared_), pointsOf);
    expert_ = task_->expert.empty()
                  ? OtherTry{}
                  : readTry(task_->expert, origin_, pivotOf(*task_, uncut_->mesh));
    openLast(person);
}

void Practice::change(const Document& document, bool spares) {
    task_ = document.session.task;
    draft_ = draftOf(*task_, document);
    score_.reset();
    passed_.reset();
    revision_ = -1;
    uncut_ = spares ? nullptr : uncut_;
}

/// The line ends where its neighbouring points lie on two sides of a cut.
void Practice::layLine(const std::vector<SurfaceAnchor>& anchors, const SurfaceMesh& mesh,
                       bool closed) {
    const Vec3 into = task_->into.normalized();
    const double width = task_->limits.deviation.value_or(0);
    const std::size_t count = anchors.size();
    const std::vector<Vec3> at =
        mapped(anchors, [&](const SurfaceAnchor& anchor) { return anchor.position(mesh); });
    const auto goesOn = [&](std::size_t i) {
        const std::size_t next = (i + 1) % count;
        const double atRest = (anchors[next].rest() - anchors[i].rest()).norm();
        return (closed || next > 0) && (at[next] - at[i]).norm() <= kMostStretch * atRest;
    };
    std::vector<Vec3> aside;  // to the edge of the band
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t before = (i + count - 1) % count;
        const Vec3 way = at[goesOn(i) ? (i + 1) % count : i] - at[goesOn(before) ? before : i];
        aside.emplace_back(width * way.cross(into).stableNormalized());
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (!goesOn(i)) {
            continue;
        }
        const std::size_t next = (i + 1) % count;
        const Vec3 normal = areaNormal(cornersOf(mesh, anchors[i].triangle()));
        traces_.push_back({Kind::line, at[i], at[next], normal});
        if (width > 0) {
            traces_.push_back({Kind::band, at[i] - aside[i], at[next] - aside[next], normal});
            traces_.push_back({Kind::band, at[i] + aside[i], at[next] + aside[next], normal});
        }
    }
}

/// The lines move with the skin; where that was cut away, they end.
void Practice::layLines(EditorScene& scene) {
    const SurfaceMesh& mesh = scene.simulation().meshAsRead();
    traces_.clear();
    std::vector<int> corners;  // read back together, not anchor by anchor
    for (std::vector<SurfaceAnchor>& line : lines_) {
        std::erase_if(line, [&](SurfaceAnchor& anchor) { return !anchor.follow(mesh); });
        for (const SurfaceAnchor& anchor : line) {
            const Triangle& triangle = mesh.triangle(anchor.triangle());
            corners.insert(corners.end(), triangle.begin(), triangle.end());
        }
    }
    mesh.bring(corners);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        layLine(lines_[i], mesh, task_->lines[i].closed);
    }
    if (score_) {
        layRim(scene);
    }
}

/// The edges of the cut in the skin, by their deviation.
void Practice::layRim(EditorScene& scene) {
    const SurfaceMesh& mesh = scene.simulation().mesh();
    const double limit = task_->limits.deviation.value_or(task_->reach);
    for (const auto& [h, deviation] : rimDeviations(*task_, scene.simulation())) {
        const int skin = SurfaceMesh::triangleOf(mesh.twin(h));
        const bool isNear = deviation && *deviation <= limit;
        traces_.push_back({isNear ? Kind::near : Kind::far, mesh.position(mesh.origin(h)),
                           mesh.position(mesh.target(h)), areaNormal(cornersOf(mesh, skin))});
    }
}

bool Practice::follow(EditorScene& scene, const ui::Settings& settings) {
    const bool other = uncut_ != scene.simulation().uncut();
    const bool hadTask = task_.has_value();
    if (other) {
        open(scene, settings.person);
    }
    if (!task_) {
        return hadTask;
    }
    if (lastPerson_ != settings.person) {
        openLast(settings.person);
    }
    if (score_ && (deeds_ != scene.recorder().deeds() || scene.timeline().inThePast() ||
                   scene.simulation().strokes().empty())) {
        score_.reset();  // of what is not there now
        revision_ = -1;
        openLast(settings.person);
    }
    const bool begins =
        scene.stroke().drawing() && !cutting_ && scene.simulation().strokes().empty();
    cutting_ = scene.stroke().drawing();
    if (begins) {
        watch_.restart();
    }
    const bool moved = std::exchange(revision_, scene.simulation().bodyRevision()) !=
                       scene.simulation().bodyRevision();
    if (moved) {
        layLines(scene);
    }
    return moved || other || score_ || (settings.showExpert && !expert_.hand.empty());
}

bool Practice::isDue(const EditorScene& scene) const {
    return finishing_ && task_ && uncut_ == scene.simulation().uncut() &&
           !scene.stroke().drawing() && scene.stroke().pending() == 0;
}

std::string Practice::judge(EditorScene& scene, Session played, const std::string& person) {
    finishing_ = false;
    if (scene.timeline().inThePast()) {
        return "The body is shown as it was earlier; go to the end of the time line, then finish.";
    }
    played.task->person = person;
    played.task->date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    score_ = scoreOf(played, scene.simulation(), scene.readout().forces());
    if (!score_) {
        return "Nothing was cut yet: lead the blade along the line first.";
    }
    if (score_->passed()) {
        passed_ = {played, *score_};
    }
    deeds_ = scene.recorder().deeds();
    revision_ = -1;
    scored_.hand = handOf(played);
    scored_.share = handShare(scored_.hand, pivotOf(*task_, uncut_->mesh));
    watch_.restart();
    if (folder_.empty()) {
        return "";
    }
    std::string name = fileNameOf(task_->name, person) + played.task->date;
    std::ranges::replace(name, ':', '-');
    const std::filesystem::path file = folder_ / (name + std::string(kSessionEnding));
    try {
        std::filesystem::create_directories(folder_);
        writeOutputFile(file, formatSession(played, folder_));
        writeOutputFile(scoreFileOf(file), toJson(*score_, *played.task).dump(2) + "\n");
    } catch (const std::exception& problem) {
        return std::string("The try was not kept: ") + problem.what();
    }
    return "";
}

/// Both blades begin together, and the longer try says when again.
void Practice::addHand(const OtherTry& shown, Kind kind, ui::Overlay& overlay,
                       const ViewFrame& view) const {
    const auto lengthOf = [](const std::vector<HandPose>& hand) {
        return hand.empty() ? 0 : hand.back().time - hand.front().time;
    };
    const double length =
        std::max(lengthOf(expert_.hand), score_ ? lengthOf(scored_.hand) : 0) + kPause;
    const double first = shown.hand.front().time;
    const double time = first + std::fmod(watch_.seconds(), length);
    const auto add = [&](const Vec3& from, const Vec3& to) {
        addLines(kind, from, to, view, overlay);
    };
    std::optional<Vec3> before;
    for (double at = std::max(first, time - kTrail); at <= time; at += kTrail / 20) {
        const std::optional<Blade> pose = poseAt(shown.hand, at);
        const auto point = pose ? std::optional(handPoint(*pose, shown.share)) : std::nullopt;
        if (point && before) {
            add(*before, *point);
        }
        before = point;
    }
    if (const std::optional<Blade> pose = poseAt(shown.hand, time)) {
        add(pose->a, pose->b);
        if (const auto pixel = view.toPixel(handPoint(*pose, shown.share))) {
            overlay.dots.push_back(*pixel);
        }
    }
}

void Practice::addTo(ui::Overlay& overlay, const ViewFrame& view,
                     const ui::Settings& settings) const {
    if (!task_) {
        return;
    }
    for (const std::vector<Vec3>& part : spared_) {
        std::vector<ui::PlotPoint> pixels;
        for (const Vec3& point : part) {
            if (const auto pixel = view.toPixel(point)) pixels.push_back(*pixel);
        }
        const std::vector<ui::PlotPoint> outline = outlineOf(std::move(pixels));
        for (std::size_t i = 0; i < outline.size(); ++i) {
            overlay.traces.push_back(
                {Kind::spared, {outline[i], outline[(i + 1) % outline.size()]}});
        }
    }
    for (const WorldTrace& trace : traces_) {
        const Vec3 sight =
            view.camera.orthographic ? view.camera.forward() : Vec3(trace.from - view.camera.eye);
        if (trace.normal.dot(sight) <= 0) {
            addLines(trace.kind, trace.from, trace.to, view, overlay);
        }
    }
    for (std::size_t i = 1; settings.showLastTry && i < last_.hand.size(); ++i) {
        if (!last_.hand[i].begins) {
            addLines(Kind::last, handPoint(last_.hand[i - 1].blade, last_.share),
                     handPoint(last_.hand[i].blade, last_.share), view, overlay);
        }
    }
    if (settings.showExpert && !expert_.hand.empty()) {
        addHand(expert_, Kind::expert, overlay, view);
    }
    if (score_) {
        addHand(scored_, Kind::last, overlay, view);
    }
}

void Practice::describe(ui::PracticeState& state) const {
    if (!task_) {
        return;
    }
    state.name = task_->name;
    state.about = task_->about + (expert_.problem.empty() ? "" : " " + expert_.problem);
    state.draft = draft_;
    state.hasExpert = !expert_.hand.empty();
    state.hasLast = !last_.hand.empty();
    state.finished = score_.has_value();
    state.violations = score_ ? score_->violations : std::vector<std::string>{};
    state.advice = score_ ? adviceOn(*score_, *task_) : "";
    auto last = last_.figures;
    auto expert = expert_.figures;
    for (const FigureRow& row : figureRows()) {
        const std::string unit = *row.unit.name == 0 ? "" : fmt::format(" [{}]", row.unit.name);
        const bool broken = score_ && !isKept(row, *score_, *task_);
        const std::optional<double> value = score_ ? valueOf(row, *score_) : std::nullopt;
        const std::optional<double> limit = limitOf(row, *task_);
        ui::ScoreRow shown{row.label + unit, formatFigure(row.unit, value),        last[row.key],
                           expert[row.key],  limit ? shortLimit(row, *limit) : "", broken};
        if (!shown.now.empty() || !shown.last.empty() || !shown.expert.empty()) {
            state.rows.push_back(std::move(shown));
        }
    }
}

}  // namespace kerf::app
