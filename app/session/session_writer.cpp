#include <cmath>

#include "app/session/event_table.h"
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

/// A value that JSON knows as it is.
template <class Value>
requires std::is_same_v<Value, bool> || std::is_same_v<Value, int> ||
    std::is_same_v<Value, std::string>
        Json toJson(const Value& value) {
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

Json toJson(const Params& params) {
    Json json;
    for (const ParamInfo& info : paramTable()) {
        json[std::string(info.name)] = toJson(getParam(params, info.name));
    }
    return json;
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

/// Writes the fields of an object as describe() names them.
struct FieldWriter {
    Json& json;

    void type(const char* name) { json["type"] = name; }
    void type(const char* name, const char* otherwise, bool flag) { type(flag ? name : otherwise); }
    void required(const char* key, const auto& value, const auto&...) { json[key] = toJson(value); }
    void optional(const char* key, const auto& value, const auto&...) { json[key] = toJson(value); }
    void optional(const char* key, bool flag) {
        if (flag) {
            json[key] = true;
        }
    }
    template <class Value>
    void optional(const char* key, const std::optional<Value>& value, const auto&...) {
        if (value) {
            json[key] = toJson(*value);
        }
    }
    void either(const Region&, Keys, Keys, std::string_view) {}
    void param(const char* nameKey, const std::string& name, const char* valueKey,
               const ParamValue& value) {
        json[nameKey] = name;
        json[valueKey] = toJson(value);
    }
    void check(bool, const char*, std::string_view) {}
};

template <class Described>
requires requires(FieldWriter fields, Described item) {
    describe(fields, item);
}
Json toJson(Described item) {
    Json json;
    FieldWriter fields{json};
    describe(fields, item);
    return json;
}

Json toJson(SessionEvent event) {
    Json json;
    json["step"] = event.step;
    FieldWriter fields{json};
    std::visit([&](auto& action) { describe(fields, action); }, event.action);
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
