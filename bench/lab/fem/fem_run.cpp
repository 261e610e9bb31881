#include "bench/lab/fem/fem_run.h"

#include <algorithm>

#include "app/files/export/export.h"
#include "app/files/import/model_source.h"
#include "app/session/iteration_watch.h"
#include "app/session/session_runner.h"
#include "sim/mesh/invariants.h"

namespace kerf::app {

namespace {

constexpr int kWindow = 40;          // steps between two looks
constexpr double kSettled = 1e-4;    // change in a window, of how far the body has moved in all
constexpr double kMostSeconds = 20;  // of the load; then it has not settled

/// Leads a simulation through a session until the body rests.
class RestRun {
  public:
    RestRun(const Session& session, ModelMesh model)
        : player_(session),
          simulation_(std::move(model.mesh), session.params),
          runner_(simulation_) {}

    SurfaceMesh mesh() { return simulation_.mesh(); }
    std::string stateHash() { return simulation_.stateHash(); }
    std::string tooFew() const { return iterations_.sentence(); }
    int stepCount() const { return simulation_.stepCount(); }

    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            runner_.applyActions(player_, *this);
            iterations_.add(simulation_.stepCount(), simulation_.bodyModel(), simulation_.params());
            for (const std::string& problem : runner_.newlyBroken(runner_.step())) {
                throw InputError("fem: step " + std::to_string(stepCount()) + ": " + problem + ".");
            }
        }
    }

    /// Steps until the piece that holds `vertex` stands still. False where it does not in time.
    bool settle(int vertex, double seconds) {
        std::vector<Vec3> before = surfaceOf(simulation_.mesh(), vertex).positions;
        while (simulation_.report().time < seconds) {
            run(kWindow);
            const LoadedSurface now = surfaceOf(simulation_.mesh(), vertex);
            if (largestWay(before, now.positions) <=
                kSettled * largestWay(now.rest, now.positions)) {
                return true;
            }
            before = now.positions;
        }
        return false;
    }

    // What happens before a step: see SessionRunner::applyActions.
    void perform(const Command& command, int) {
        const std::string problem = simulation_.execute(command);
        if (!problem.empty()) {
            throw InputError("fem: step " + std::to_string(stepCount()) + ": " + problem);
        }
    }
    template <class Event>
    void take(const Event&) {}  // pictures and checks come with the replay

  private:
    static double largestWay(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
        double most = 0;
        for (std::size_t v = 0; v < from.size(); ++v) {
            most = std::max(most, (to[v] - from[v]).norm());
        }
        return most;
    }

    SessionPlayer player_;
    Simulation simulation_;
    SessionRunner runner_;
    IterationWatch iterations_;
};

/// The vertex that is nearest to a point at rest.
int nearestVertex(const SurfaceMesh& mesh, const Vec3& point) {
    int nearest = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const double distance = (mesh.restPosition(v) - point).squaredNorm();
        if (mesh.outgoing(v) >= 0 &&
            distance < (mesh.restPosition(nearest) - point).squaredNorm()) {
            nearest = v;
        }
    }
    return nearest;
}

Session sessionOf(const FemCase& each, const FemSetting& setting,
                  const std::filesystem::path& model) {
    Session session;
    session.fileName = each.name;
    session.model.path = model;
    session.params = each.params;
    setting.apply(session.params);
    session.steps = kMaxSteps;
    session.events = each.events;
    return session;
}

}  // namespace

std::string sessionFile(const FemCase& each, const FemSetting& setting) {
    return each.name + "-" + setting.name + ".kerf.json";
}

KerfRun runKerf(const FemCase& each, const FemSetting& setting, OutputFolder& folder) {
    const std::string modelName = each.name + ".ply";
    const SurfaceMesh uncut =
        SurfaceMesh::fromTriangles(each.model.positions, each.model.triangles);
    folder.write(modelName, encodeMesh(uncut, findPieces(uncut), MeshFormat::ply));
    const std::filesystem::path model = std::filesystem::absolute(folder.pathOf(modelName));
    Session session = sessionOf(each, setting, model);
    RestRun run(session, loadSessionModel(session));
    run.run(each.loaded + 1);
    KerfRun result;
    const int vertex = nearestVertex(run.mesh(), each.pinned);
    result.settled = run.settle(vertex, each.loaded * session.params.timeStep + kMostSeconds);
    result.surface = surfaceOf(run.mesh(), vertex);
    result.steps = run.stepCount();
    result.stateHash = run.stateHash();
    result.tooFew = run.tooFew();
    session.steps = result.steps;
    folder.write(sessionFile(each, setting), formatSession(session, model.parent_path()));
    return result;
}

LoadedSurface relaxedSurface(const FemCase& each, const SolidProblem& problem) {
    return surfaceOf(problem.mesh, relaxSolid(problem).positions, each.cutPlane);
}

}  // namespace kerf::app
