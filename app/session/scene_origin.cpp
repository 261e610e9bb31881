#include "app/session/scene_origin.h"

#include "app/session/session_table.h"

namespace kerf::app {
namespace {

/// Moves the places that describe() names.
struct PlaceMover : NoFields {
    explicit PlaceMover(const Vec3& moved) : by(moved) {}

    Vec3 by;

    using NoFields::optional;
    using NoFields::required;
    void required(const Word&, Vec3& place, const Positions&) { place -= by; }
    void optional(const Word&, Vec3& place, const Positions&) { place -= by; }
    void required(const Word&, std::vector<Vec3>& places, const Positions&) {
        std::ranges::for_each(places, [this](Vec3& place) { place -= by; });
    }
    void list(const Word&, auto& items, std::size_t) {
        std::ranges::for_each(items, [this](auto& item) { describe(*this, item); });
    }
    void oneOf(Region& region, std::string_view) {
        std::visit([this](auto& shape) { describe(*this, shape); }, region);
    }
    void param(const Word&, const std::string& name, const Word&, ParamValue& value) {
        auto* number = std::get_if<double>(&value);
        if (number != nullptr && name == "floor") {
            *number -= by.y();
        }
    }
};

template <class Described>
Described moved(Described described, const Vec3& by) {
    if (by != Vec3::Zero()) {  // Nothing would change, but the sign of zeros.
        PlaceMover mover(by);
        describe(mover, described);
    }
    return described;
}

}  // namespace

SessionAction countedFrom(SessionAction action, const Vec3& by) {
    return std::visit([&](auto& kind) { return SessionAction(moved(std::move(kind), by)); },
                      action);
}

Command countedFrom(Command command, const Vec3& by) {
    return std::visit([&](auto& kind) { return Command(moved(std::move(kind), by)); }, command);
}

render::Camera countedFrom(render::Camera camera, const Vec3& by) {
    return moved(std::move(camera), by);
}

Params countedFrom(Params params, const Vec3& by) {
    if (params.floor) {
        *params.floor -= by.y();
    }
    return params;
}

std::vector<StaticBox> countedFrom(std::vector<StaticBox> boxes, const Vec3& by) {
    for (StaticBox& box : boxes) {
        box = moved(box, by);
    }
    return boxes;
}

Session withOrigin(Session session, const Vec3& origin) {
    const Vec3 by = origin - std::exchange(session.origin, origin);
    session.placement = moved(session.placement, by);
    for (FurtherModel& further : session.moreModels) {
        further.placement = moved(further.placement, by);
    }
    session.params = countedFrom(std::move(session.params), by);
    session.boxes = countedFrom(std::move(session.boxes), by);
    for (SessionEvent& event : session.events) {
        event.action = countedFrom(std::move(event.action), by);
    }
    if (session.task) {
        session.task = moved(std::move(*session.task), by);
    }
    if (session.view) {
        session.view = countedFrom(*session.view, by);
    }
    if (session.editor) {
        session.editor->camera = countedFrom(session.editor->camera, by);
        if (session.editor->section) {
            session.editor->section = moved(*session.editor->section, by);
        }
    }
    return session;
}

Command asReplayed(const Command& command, const Vec3& origin) {
    return countedFrom(countedFrom(command, -origin), origin);
}

}  // namespace kerf::app
