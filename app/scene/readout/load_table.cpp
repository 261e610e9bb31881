#include "app/scene/readout/load_table.h"

#include <spdlog/fmt/fmt.h>

#include "app/scene/timeline/hooks.h"
#include "shaders/shared/solver_uniforms.h"
#include "sim/base/text.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {
namespace {

using Vertices = std::vector<std::uint32_t>;

std::string textOf(const Vec3& v, const char* unit) {
    return fmt::format("{:.3g}, {:.3g}, {:.3g} {}", v.x(), v.y(), v.z(), unit);
}

/// Both lists ascend.
Vertices without(const Vertices& vertices, const Vertices& others) {
    Vertices left;
    std::ranges::set_difference(vertices, others, std::back_inserter(left));
    return left;
}

Vertices both(const Vertices& a, const Vertices& b) {
    Vertices all;
    std::ranges::set_union(a, b, std::back_inserter(all));
    return all;
}

/// Those that hang together along the surface; each part ascends.
std::vector<Vertices> partsOf(const Vertices& vertices, const SurfaceMesh& mesh) {
    std::set<std::uint32_t> left(vertices.begin(), vertices.end());
    std::vector<Vertices> parts;
    while (!left.empty()) {
        Vertices part{*left.begin()};
        left.erase(left.begin());
        for (std::size_t i = 0; i < part.size(); ++i) {
            mesh.forEachOutgoing(static_cast<int>(part[i]), [&](int h) {
                if (const auto to = static_cast<std::uint32_t>(mesh.target(h)); left.erase(to)) {
                    part.push_back(to);
                }
            });
        }
        std::ranges::sort(part);
        parts.push_back(std::move(part));
    }
    return parts;
}

/// Adds boxes around vertices that hold none of `others`.
void cover(std::span<std::uint32_t> vertices, const Vertices& others, double margin,
           const SurfaceMesh& mesh, std::vector<Bounds>& boxes) {
    const auto place = [&mesh](std::uint32_t v) { return mesh.position(static_cast<int>(v)); };
    const Bounds box = widened(boxOf(vertices, place), margin);
    const auto isWithin = [&](std::uint32_t v) { return contains(box, place(v)); };
    if (vertices.size() == 1 || std::ranges::none_of(others, isWithin)) {
        boxes.push_back(box);
        return;
    }
    int axis = 0;
    (box.high - box.low).maxCoeff(&axis);
    const std::size_t half = vertices.size() / 2;
    std::ranges::nth_element(vertices, vertices.begin() + static_cast<std::ptrdiff_t>(half), {},
                             [&](std::uint32_t v) { return place(v)[axis]; });
    cover(vertices.first(half), others, margin, mesh, boxes);
    cover(vertices.subspan(half), others, margin, mesh, boxes);
}

/// All that a command for a region takes away.
Vertices allLike(const Load& load, const Simulation& simulation) {
    if (load.kind != Load::Kind::force) {
        return simulation.pinnedVertices();
    }
    Vertices all;
    for (const Pins::Force& force : simulation.forces()) {
        all = both(all, force.held.vertices());
    }
    return all;
}

}  // namespace

void LoadTable::follow(const Simulation& simulation, const Vec3& origin) {
    loads_.clear();
    addPins(simulation);
    for (const Pins::Motion& motion : simulation.motions()) {
        loads_.push_back({Load::Kind::motion,
                          motion.held.vertices(),
                          motion.moved,
                          -1,
                          motion.number,
                          {},
                          {"Motion", lengthText(motion.moved.norm()),
                           "Displacement so far, at " + textOf(motion.velocity, "m/s")}});
    }
    std::ranges::for_each(simulation.forces(), [this](const auto& force) { addForce(force); });
    for (const Hands::Hand& hand : simulation.hands()) {
        addHand(hand, origin);
    }
    for (Load& load : loads_) {
        load.row.vertices = load.vertices.size();
    }
}

/// What hangs together changes by pinning and cutting only.
void LoadTable::addPins(const Simulation& simulation) {
    Vertices fixed = simulation.pinnedVertices();
    for (const Pins::Motion& motion : simulation.motions()) {
        fixed = without(fixed, motion.held.vertices());
    }
    if (fixed != fixed_ || model_ != simulation.modelRevision()) {
        fixed_ = std::move(fixed);
        model_ = simulation.modelRevision();
        pins_ = partsOf(fixed_, simulation.meshAsRead());
    }
    for (const Vertices& part : pins_) {
        loads_.push_back({.vertices = part, .row = {"Pin", "fixed", "Stays where it is"}});
    }
}

/// Forces that share vertices are told, and removed, together: a region takes all of them away.
void LoadTable::addForce(const Pins::Force& force) {
    Load all{Load::Kind::force, force.held.vertices(), force.newtons};
    std::erase_if(loads_, [&](const Load& other) {
        const bool shares = other.kind == Load::Kind::force &&
                            without(other.vertices, all.vertices).size() < other.vertices.size();
        if (shares) {
            all = {Load::Kind::force, both(other.vertices, all.vertices), other.value + all.value};
        }
        return shares;
    });
    all.row = {"Force", fmt::format("{:.3g} N", all.value.norm()),
               "On all of its vertices together: " + textOf(all.value, "N")};
    loads_.push_back(std::move(all));
}

/// The second hook of a retractor joins the first, whose place is its value.
void LoadTable::addHand(const Hands::Hand& hand, const Vec3& origin) {
    const bool hook = isHook(hand.number);
    if (!hook || loads_.empty() || loads_.back().hand != partnerOf(hand.number)) {
        loads_.push_back({Load::Kind::hand, {}, hand.to, hand.number});
        loads_.back().row = {hook ? "Retractor" : "Hand", "springs",
                             fmt::format("Pulls to {} by critically damped springs, {:g} /s",
                                         textOf(hand.to + origin, "m"), shared::kPullRate)};
    } else {
        loads_.back().row.value = lengthText((hand.to - loads_.back().value).norm());
        loads_.back().row.detail = "Distance between its hooks";
    }
    loads_.back().hands.push_back(hand.to);
    for (const Hands::Held& held : hand.held) {
        loads_.back().vertices.push_back(static_cast<std::uint32_t>(held.vertex));
    }
}

/// Pins and forces have no numbers, but keep vertices through cuts and other changes.
int rowOf(const Load& load, const std::vector<Load>& now) {
    const bool numbered = load.hand >= 0 || load.motion >= 0;
    const auto same = std::ranges::find_if(now, [&](const Load& other) {
        return other.kind == load.kind && other.hand == load.hand && other.motion == load.motion &&
               (numbered || without(load.vertices, other.vertices).size() < load.vertices.size());
    });
    return same != now.end() ? static_cast<int>(same - now.begin()) : -1;
}

std::vector<Command> removalOf(const Load& load, Simulation& simulation) {
    constexpr double kMargin = 1e-6;  // of the body's diagonal: what is saved is rounded
    Vertices vertices = load.vertices;
    const Vertices others = without(allLike(load, simulation), vertices);
    std::vector<Bounds> boxes;
    cover(vertices, others, kMargin * simulation.bounds().diagonal(), simulation.mesh(), boxes);
    std::vector<Command> commands;
    for (const Bounds& box : boxes) {
        const bool continues = !commands.empty();
        if (load.kind == Load::Kind::force) {
            commands.emplace_back(ApplyForce{box, Vec3::Zero(), continues});
        } else {
            commands.emplace_back(Pin{box, false, continues});
        }
    }
    return commands;
}

}  // namespace kerf::app
