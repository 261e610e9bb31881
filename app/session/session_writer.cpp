#include <cmath>

#include "app/session/session.h"
#include "app/session/session_json.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

Json toJson(double value) {
    if (!std::isfinite(value)) {
        throw InputError("A session can't hold a number that is not finite.");
    }
    return value;
}

Json toJson(const Vec3& v) {
    return Json::array({toJson(v.x()), toJson(v.y()), toJson(v.z())});
}

Json toJson(const ParamValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return toJson(*number);
    if (const auto* vector = std::get_if<Vec3>(&value)) return toJson(*vector);
    if (const auto* choice = std::get_if<std::string>(&value)) return *choice;
    return nullptr;
}

Json toJson(const ModelReference& model, const std::filesystem::path& baseFolder) {
    Json json;
    if (!model.builtin.empty()) {
        json["builtin"] = model.builtin;
    } else {
        json["path"] =
            (baseFolder.empty() ? model.path : model.path.lexically_proximate(baseFolder))
                .generic_string();
    }
    if (!model.sha256.empty()) {
        json["sha256"] = model.sha256;
    }
    if (model.fillHoles) {
        json["fill_holes"] = true;
    }
    return json;
}

Json toJson(const Placement& placement) {
    return {{"scale", toJson(placement.scale)},
            {"rotate", toJson(placement.rotate)},
            {"translate", toJson(placement.translate)}};
}

Json toJson(const Params& params) {
    Json json;
    for (const ParamInfo& info : paramTable()) {
        json[std::string(info.name)] = toJson(getParam(params, info.name));
    }
    return json;
}

Json toJson(const StaticBox& box) {
    return {
        {"center", toJson(box.center)}, {"size", toJson(box.size)}, {"rotate", toJson(box.rotate)}};
}

Json toJson(const render::Camera& camera) {
    return {{"eye", toJson(camera.eye)},
            {"target", toJson(camera.target)},
            {"up", toJson(camera.up)},
            {"fov_y", toJson(camera.fovY)},
            {"orthographic", camera.orthographic}};
}

/// The colours lie beside the camera.
Json viewOf(const Session& session) {
    Json json = toJson(*session.view);
    if (session.colors.skin) {
        json["skin"] = toJson(*session.colors.skin);
    }
    if (session.colors.flesh) {
        json["flesh"] = toJson(*session.colors.flesh);
    }
    return json;
}

/// Puts the keys of one action behind "step".
struct ActionWriter {
    Json& json;

    void operator()(const MoveBlade& move) const {
        json["type"] = "blade";
        json["a"] = toJson(move.blade.a);
        json["b"] = toJson(move.blade.b);
    }
    void operator()(const LiftBlade&) const { json["type"] = "lift"; }
    void operator()(const SetParam& set) const {
        json["type"] = "set";
        json["name"] = set.name;
        json["value"] = toJson(set.value);
        if (set.continues) json["continues"] = true;
    }
    void operator()(const Grab& grab) const {
        json["type"] = "grab";
        json["hand"] = grab.hand;
        json["at"] = toJson(grab.at);
        json["radius"] = toJson(grab.radius);
    }
    void operator()(const Drag& drag) const {
        json["type"] = "drag";
        json["hand"] = drag.hand;
        json["to"] = toJson(drag.to);
    }
    void operator()(const Release& release) const {
        json["type"] = "release";
        json["hand"] = release.hand;
    }
    void operator()(const Pin& pin) const {
        json["type"] = pin.pinned ? "pin" : "unpin";
        if (const auto* ball = std::get_if<Ball>(&pin.region)) {
            json["center"] = toJson(ball->center);
            json["radius"] = toJson(ball->radius);
        } else {
            json["low"] = toJson(std::get<Bounds>(pin.region).low);
            json["high"] = toJson(std::get<Bounds>(pin.region).high);
        }
        if (pin.continues) {
            json["continues"] = true;
        }
    }
    void operator()(const AddBox& add) const {
        json["type"] = "add_box";
        json.update(toJson(add.box));
    }
    void operator()(const ChangeBox& change) const {
        json["type"] = "change_box";
        json["box"] = change.index;
        json.update(toJson(change.box));
        if (change.continues) json["continues"] = true;
    }
    void operator()(const RemoveBox& remove) const {
        json["type"] = "remove_box";
        json["box"] = remove.index;
    }
    void operator()(const Restart&) const { json["type"] = "restart"; }
    void operator()(const Undo&) const { json["type"] = "undo"; }
    void operator()(const Redo&) const { json["type"] = "redo"; }
    void operator()(const ScreenshotEvent& event) const {
        json["type"] = "screenshot";
        json["file"] = event.file;
        json["width"] = event.width;
        json["height"] = event.height;
    }
    void operator()(const ExportEvent& event) const {
        json["type"] = "export";
        json["file"] = event.file;
        if (event.filePerPiece) json["per_piece"] = true;
    }
    void operator()(const CheckEvent& event) const {
        json["type"] = "check";
        if (event.hash) json["hash"] = *event.hash;
        if (event.pieces) json["pieces"] = *event.pieces;
    }
};

Json toJson(const SessionEvent& event) {
    Json json;
    json["step"] = event.step;
    std::visit(ActionWriter{json}, event.action);
    return json;
}

/// A list with one line each.
template <class Item>
std::string linesOf(const std::vector<Item>& items) {
    std::string lines;
    for (const Item& item : items) {
        lines += (lines.empty() ? "\n    " : ",\n    ") + toJson(item).dump();
    }
    return lines.empty() ? "[]" : "[" + lines + "\n  ]";
}

}  // namespace

std::string formatSession(const Session& session, const std::filesystem::path& baseFolder) {
    std::string text = "{\n  \"format\": \"kerf-session\", \"version\": 1,\n";
    text += "  \"model\": " + toJson(session.model, baseFolder).dump() + ",\n";
    text += "  \"placement\": " + toJson(session.placement).dump() + ",\n";
    text += "  \"params\": " + toJson(session.params).dump() + ",\n";
    if (!session.boxes.empty()) {
        text += "  \"boxes\": " + linesOf(session.boxes) + ",\n";
    }
    text += "  \"steps\": " + std::to_string(session.steps) + ",\n";
    text += "  \"events\": " + linesOf(session.events);
    if (session.view) {
        text += ",\n  \"view\": " + viewOf(session).dump();
    }
    return text + "\n}\n";
}

}  // namespace kerf::app
