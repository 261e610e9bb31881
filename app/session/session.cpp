#include "app/session/session.h"

#include <spdlog/fmt/fmt.h>

#include <type_traits>

#include "app/files/import/builtin_models.h"
#include "app/files/import/import_answer.h"
#include "app/files/import/joined_models.h"
#include "app/files/import/model_units.h"
#include "app/files/io/encodings.h"
#include "sim/base/size_params.h"
#include "sim/base/text.h"
#include "sim/mesh/invariants.h"

namespace kerf::app {

namespace {

// The default view stands this much further away than the model alone needs: pieces fall and roll.
constexpr double kRoomToFall = 1.25;

void requireDigest(const std::filesystem::path& file, const std::string& expected) {
    if (!expected.empty() && sha256OfFile(file) != expected) {
        throw InputError(file.filename().string() +
                         ": the model is not the one that the session was made with (its SHA-256 "
                         "differs); restore it or take \"sha256\" out of the session.");
    }
}

}  // namespace

void place(SurfaceMesh& mesh, const Placement& placement) {
    const PlacementMap map(placement);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 placed = map.toScene(mesh.restPosition(v));
        mesh.setPosition(v, placed);
        mesh.setRestPosition(v, placed);
    }
}

Coordinates coordinatesOf(const ExportEvent& event, const Placement& placement) {
    return event.coordinates.value_or(placement.unit ? Coordinates::model : Coordinates::scene);
}

std::filesystem::path ModelReference::file() const {
    return builtin.empty() ? path : builtinModelFile(builtin);
}

std::string ModelReference::name() const {
    const std::string whole = builtin.empty() ? path.stem().string() : builtin;
    return object ? whole + " " + std::to_string(*object) : whole;
}

namespace {

std::vector<ModelReference> modelsOf(const Session& session) {
    std::vector<ModelReference> models{session.model};
    std::ranges::transform(session.moreModels, std::back_inserter(models), &FurtherModel::model);
    return models;
}

/// The models in the numbers of their files, each of which is read once.
std::vector<ModelMesh> readAll(const std::vector<ModelReference>& references,
                               const ReadOptions& options) {
    // The numbers of equal models, by their file and what is ordered.
    std::map<std::filesystem::path, std::map<std::string, std::vector<std::size_t>>> files;
    std::set<std::pair<std::filesystem::path, std::string>> checked;
    for (std::size_t m = 0; m < references.size(); ++m) {
        if (checked.emplace(references[m].file(), references[m].sha256).second) {
            requireDigest(references[m].file(), references[m].sha256);
        }
        ImportOrder order = options;
        order.object = references[m].object.value_or(0);
        order.add(references[m]);
        files[references[m].file()][encodeOrder(order)].push_back(m);
    }
    std::vector<ModelMesh> models(references.size(), SurfaceMesh());
    for (const auto& [file, wanted] : files) {
        std::vector<ImportOrder> orders;
        for (const auto& [letters, equal] : wanted) {
            orders.push_back(decodeOrder(letters));
        }
        auto answers = importModels(file, orders, options.progress);
        enter(options.progress, "Building the surface");
        auto answer = answers.begin();
        for (const auto& [letters, equal] : wanted) {
            const ModelMesh& first = models[equal.front()] =
                cuttableModel(file, std::move(*answer++));
            for (const std::size_t number : equal) {
                models[number] = first;
            }
        }
    }
    return models;
}

/// What people should know of models that floats can't hold where they lie.
std::string remarkOnOrigin(const Bounds& all, const Vec3& origin) {
    if (checkRoom(all).empty()) {
        return "";
    }
    return fmt::format(
        "The scene lies {:.7g} m from the origin, too far for the floats of a simulation: it runs "
        "about ({:.10g}, {:.10g}, {:.10g}), and files keep their coordinates, STL as floats.",
        all.center().norm(), origin.x(), origin.y(), origin.z());
}

/// What people should know of a model that the floor will push up at once.
std::string remarkOnFloor(const std::string& name, const Bounds& placed, double floor) {
    constexpr double kDeep = 0.005;  // of the model
    const double depth = floor - placed.low.y();
    if (depth < kDeep * placed.diagonal()) {
        return "";
    }
    return fmt::format(
        "{} starts {} below the floor and will be pushed up; raise it by \"placement\".", name,
        lengthText(depth));
}

/// Puts models where the scene has them, counted from an origin beside them.
void placeAll(std::vector<ModelMesh>& models, const std::vector<Placement>& placements) {
    std::vector<Bounds> bounds;
    Bounds all;
    for (std::size_t m = 0; m < models.size(); ++m) {
        bounds.push_back(placedBounds(models[m].mesh.restPositions(), placements[m]));
        all.add(bounds.back());
    }
    const Vec3 origin = originOf(all);
    for (std::size_t m = 0; m < models.size(); ++m) {
        if (const std::string problem = checkRoom(bounds[m], origin); !problem.empty()) {
            const std::string key = m == 0 ? "" : fmt::format("more_models[{}].", m - 1);
            throw InputError(fmt::format("{}placement: {}", key, problem));
        }
        Placement placement = placements[m];
        placement.translate -= origin;
        place(models[m].mesh, placement);
        models[m].placed = {{placement, 0}};
        models[m].origin = origin;
    }
    if (std::string remark = remarkOnOrigin(all, origin); !remark.empty()) {
        models.front().remarks.push_back(std::move(remark));
    }
}

}  // namespace

ModelMesh loadSessionModel(const Session& session, const ReadOptions& options) {
    const std::vector<ModelReference> references = modelsOf(session);
    std::vector<ModelMesh> models = readAll(references, options);
    std::vector<Placement> placements{session.placement};
    for (const FurtherModel& further : session.moreModels) {
        if (further.color) {
            paint(models[placements.size()], further.model.name(), *further.color);
        }
        placements.push_back(further.placement);
    }
    for (Placement& placement : placements) {
        placement.translate += session.origin;
    }
    placeAll(models, placements);
    for (std::size_t m = 0; m < models.size() && session.params.floor; ++m) {
        const Bounds placed = meshBounds(models[m].mesh);
        const double floor = *session.params.floor + session.origin.y() - models[m].origin.y();
        if (std::string remark = remarkOnFloor(references[m].name(), placed, floor);
            !remark.empty()) {
            models[m].remarks.push_back(std::move(remark));
        }
    }
    return joinedModels(std::move(models));
}

ModelMesh loadSessionModel(const Session& session) {
    return loadSessionModel(session, {});
}

render::Camera sessionCamera(const Session& session, const Bounds& bounds) {
    if (session.view) {
        return *session.view;
    }
    render::Camera camera;
    camera.target = bounds.center();
    camera.eye = camera.target + Vec3(3, 2, 4);
    camera.frame(bounds);
    camera.zoom(kRoomToFall, Vec2::Zero(), 1);
    return camera;
}

render::CameraPath cameraPathOf(const Session& session) {
    std::vector<render::CameraKey> keys;
    for (const SessionEvent& event : session.events) {
        if (const auto* key = std::get_if<CameraEvent>(&event.action)) {
            keys.push_back({static_cast<double>(event.step), key->camera});
        }
    }
    return render::CameraPath(std::move(keys));
}

void takeModelOut(Session& session, int model) {
    session.moreModels.erase(session.moreModels.begin() + model - 1);
    std::vector<OwnMaterial>& own = session.params.models;
    if (static_cast<std::size_t>(model) <= own.size()) {
        own.erase(own.begin() + model - 1);
    }
}

std::optional<Command> commandOf(const SessionAction& action) {
    return std::visit(
        [](const auto& kind) -> std::optional<Command> {
            if constexpr (std::is_constructible_v<Command, decltype(kind)>) {
                return Command(kind);
            } else {
                return std::nullopt;
            }
        },
        action);
}

std::vector<std::filesystem::path> modelFiles(const Session& session) {
    std::vector<std::filesystem::path> files;
    std::ranges::transform(modelsOf(session), std::back_inserter(files), &ModelReference::file);
    return files;
}

const std::string* fileOf(const SessionAction& action) {
    return std::visit(
        [](const auto& kind) -> const std::string* {
            if constexpr (requires { kind.file; }) {
                return &kind.file;
            } else {
                return nullptr;
            }
        },
        action);
}

std::vector<std::string> pictureFiles(const Session& session) {
    std::vector<std::string> files;
    for (const SessionEvent& event : session.events) {
        const auto* picture = std::get_if<ScreenshotEvent>(&event.action);
        if (picture != nullptr && std::ranges::find(files, picture->file) == files.end()) {
            files.push_back(picture->file);
        }
    }
    return files;
}

bool startsAnew(const SessionAction& action) {
    return std::holds_alternative<Restart>(action) || std::holds_alternative<Place>(action);
}

bool takesBladeAway(const SessionAction& action) {
    return std::holds_alternative<LiftBlade>(action) || startsAnew(action) ||
           std::holds_alternative<Undo>(action) || std::holds_alternative<Redo>(action);
}

std::optional<double> bladeLengthOf(const Session& session) {
    for (const SessionEvent& event : session.events) {
        if (const auto* move = std::get_if<MoveBlade>(&event.action)) {
            return cut::lengthOf(move->blade);
        }
    }
    return std::nullopt;
}

bool undoesAnything(const Session& session) {
    return std::ranges::any_of(session.events, [](const SessionEvent& event) {
        return std::holds_alternative<Undo>(event.action);
    });
}

SessionSchedule::SessionSchedule(const Session& session) : session_(&session) {
    collectBladeMoves();
    collectHandMoves();
}

void SessionSchedule::collectBladeMoves() {
    const SessionEvent* lastKey = nullptr;
    for (const SessionEvent& event : session_->events) {
        if (takesBladeAway(event.action)) {
            lastKey = nullptr;
        } else if (const auto* move = std::get_if<MoveBlade>(&event.action)) {
            if (lastKey != nullptr && lastKey->step + 1 < event.step) {
                moves_.push_back(
                    {lastKey->step, event.step, event.number,
                     [from = std::get<MoveBlade>(lastKey->action), to = *move](double share) {
                         return MoveBlade{interpolate(from.blade, to.blade, share), to.seconds};
                     }});
            }
            lastKey = &event;
        }
    }
}

void SessionSchedule::collectHandMoves() {
    struct Key {
        int step = 0;
        Vec3 at = Vec3::Zero();
    };
    std::map<int, Key> keys;  // by hand
    for (const SessionEvent& event : session_->events) {
        if (const auto* grab = std::get_if<Grab>(&event.action)) {
            keys[grab->hand] = {event.step, grab->at};
        } else if (const auto* drag = std::get_if<Drag>(&event.action)) {
            const auto last = keys.find(drag->hand);
            if (last != keys.end() && last->second.step + 1 < event.step) {
                moves_.push_back({last->second.step, event.step, event.number,
                                  [from = last->second.at, to = *drag](double share) {
                                      return Drag{to.hand, from + share * (to.to - from)};
                                  }});
            }
            keys[drag->hand] = {event.step, drag->to};
        } else if (const auto* release = std::get_if<Release>(&event.action)) {
            keys.erase(release->hand);
        } else if (startsAnew(event.action)) {
            keys.clear();
        }
    }
}

std::vector<PlayedAction> SessionSchedule::actionsAt(int step) const {
    const auto byStep = [](const SessionEvent& event, int value) { return event.step < value; };
    const auto& events = session_->events;
    std::vector<PlayedAction> actions;
    for (auto event = std::lower_bound(events.begin(), events.end(), step, byStep);
         event != events.end() && event->step == step; ++event) {
        actions.push_back({event->action, event->number});
    }
    std::ranges::move(posesBetweenKeys(step), std::back_inserter(actions));
    return actions;
}

std::vector<PlayedAction> SessionSchedule::posesBetweenKeys(int step) const {
    std::vector<PlayedAction> poses;
    for (const KeyMove& move : moves_) {
        if (step > move.firstStep && step < move.lastStep) {
            const double share = double(step - move.firstStep) / (move.lastStep - move.firstStep);
            poses.push_back({move.at(share), move.number});
        }
    }
    return poses;
}

}  // namespace kerf::app
