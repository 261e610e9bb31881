// The paper's own course (open_cut) against the closed one: each of the shipped sessions of the
// paper's models, and open-cut, is played for up to 400 steps, both ways. One JSON object per row.
//   kerf_open_cut_bench [NAME...]

#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "app/files/import/model_source.h"
#include "app/session/session.h"
#include "gpu/context.h"
#include "gpu/data_path.h"
#include "sim/mesh/triangle.h"
#include "sim/run/simulation.h"

namespace kerf {
namespace {

// Of a triangle: height over longest edge. Below, it is a sliver.
constexpr double kSliver = 0.02;

struct Figures {
    double leastVolume = 1;  ///< while the blade is in the body, share of rest
    double mostVolume = 1;
    double finalVolume = 0;
    int mostAbsent = 0;
    WoundClosing closing;
    int walls = 0;  ///< triangles of the wound in the end
    int slivers = 0;
    int triangles = 0;
    int pieces = 0;
    double cutMs = 0;
    double longestCutMs = 0;  ///< of one step
    std::vector<std::string> messages;
};

double quality(const SurfaceMesh& mesh, int t) {
    const Corners rest = restCornersOf(mesh, t);
    const double longest = longestEdgeSquare(rest);
    return longest > 0 ? areaNormal(rest).norm() / longest : 0;
}

class Play {
  public:
    Play(const app::Session& session, bool open)
        : schedule_(session),
          simulation_(app::loadSessionModel(session).mesh, withTrace(session.params, open)) {}

    Figures run(int steps) {
        for (int step = 0; step < steps; ++step) {
            for (const app::PlayedAction& played : schedule_.actionsAt(step)) {
                std::visit(*this, played.action);
            }
            note(simulation_.step());
        }
        noteEnd();
        return figures_;
    }

    template <class Action>
    void operator()(const Action& action) {
        if constexpr (std::is_constructible_v<Command, Action>) {
            simulation_.execute(action);
        }
    }

  private:
    static Params withTrace(Params params, bool open) {
        params.openCut = open ? 1 : 0;
        return params;
    }

    void note(const StepReport& report) {
        const bool inBody = !simulation_.rung().empty();
        if (inBody) {
            figures_.leastVolume = std::min(figures_.leastVolume, report.volumeRatio);
            figures_.mostVolume = std::max(figures_.mostVolume, report.volumeRatio);
        }
        if (report.open) {
            const auto absent = static_cast<int>(absentTriangles(simulation_.mesh()).size());
            figures_.mostAbsent = std::max(figures_.mostAbsent, absent);
        }
        const WoundClosing& closing = simulation_.lastCut().statistics.closing;
        if (report.times.cut > 0 && closing.patches > 0) {
            figures_.closing = closing;
        }
        figures_.cutMs += report.times.cut;
        figures_.longestCutMs = std::max(figures_.longestCutMs, report.times.cut);
    }

    void noteEnd() {
        const SurfaceMesh& mesh = simulation_.mesh();
        for (int t = 0; t < mesh.triangleSlots(); ++t) {
            if (mesh.alive(t) && mesh.kind(t) == SurfaceKind::wall) {
                ++figures_.walls;
                figures_.slivers += quality(mesh, t) < kSliver;
            }
        }
        figures_.finalVolume = simulation_.report().volumeRatio;
        figures_.triangles = simulation_.report().triangles;
        figures_.pieces = simulation_.report().pieces;
        figures_.messages = simulation_.takeMessages();
    }

    app::SessionSchedule schedule_;
    Simulation simulation_;
    Figures figures_;
};

void print(const std::string& name, bool open, const Figures& f) {
    const nlohmann::ordered_json row{
        {"name", "open_cut/" + name},
        {"course", open ? "open" : "closed"},
        {"volume_least_cutting", f.leastVolume},
        {"volume_most_cutting", f.mostVolume},
        {"volume_end", f.finalVolume},
        {"pieces", f.pieces},
        {"triangles", f.triangles},
        {"wall_triangles", f.walls},
        {"wall_slivers", f.slivers},
        {"absent_most", f.mostAbsent},
        {"patches", f.closing.patches},
        {"cut_ms", f.cutMs},
        {"longest_cut_ms", f.longestCutMs},
        {"messages", f.messages},
    };
    std::printf("%s\n", row.dump().c_str());
    std::fflush(stdout);
}

void compare(const std::string& name) {
    const app::Session session =
        app::readSession(gpu::dataPath("assets/sessions/" + name + ".kerf.json"));
    for (const bool open : {false, true}) {
        print(name, open, Play(session, open).run(std::min(session.steps, 400)));
    }
}

}  // namespace
}  // namespace kerf

int main(int count, char** words) {
    try {
        const kerf::gpu::EglContext context;
        std::vector<std::string> names(words + 1, words + count);
        if (names.empty()) {
            names = {"sphere20", "sphere80", "sphere768", "octopus", "banana", "open-cut"};
        }
        for (const std::string& name : names) {
            kerf::compare(name);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
