#include "app/files/io/errors.h"
#include "app/session/scene_origin.h"
#include "app/session/session_json.h"
#include "app/session/session_table.h"

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

Json toJson(const std::filesystem::path& path) {
    return path.generic_string();
}

Json toJson(const std::vector<std::string>& texts) {
    return texts;
}

Json toJson(const std::vector<int>& numbers) {
    return numbers;
}

Json toJson(const std::vector<Vec3>& points) {
    Json json = Json::array();
    for (const Vec3& point : points) {
        json.push_back(toJson(point));
    }
    return json;
}

Json toJson(const Params& params) {
    Json json;
    for (const ParamInfo& info : paramTable()) {
        json[std::string(info.name)] = toJson(getParam(params, info.name));
    }
    for (const std::string& name : ownNames(params)) {
        json[name] = toJson(getParam(params, name));
    }
    return json;
}

struct FieldWriter;
template <class Described, class... Rule>
requires requires(FieldWriter& fields, Described item, Rule... rule) {
    describe(fields, item, rule...);
}
Json toJson(Described item, const Rule&... rule);

template <class Value>
Json toJson(const std::optional<Value>& value) {
    return toJson(*value);
}

/// Whether a field that may be left out must be written.
bool isGiven(const auto&) {
    return true;
}
bool isGiven(bool flag) {
    return flag;
}
bool isGiven(const std::string& text) {
    return !text.empty();
}
bool isGiven(const std::filesystem::path& path) {
    return !path.empty();
}
template <class Value>
bool isGiven(const std::optional<Value>& value) {
    return value.has_value();
}
bool isGiven(const std::vector<int>& numbers) {
    return !numbers.empty();
}
bool isGiven(const SessionView& view) {
    return view.camera.has_value();
}
bool isGiven(const render::ChosenColors& colors) {
    return colors.any();
}
bool isGiven(const MaterialValue& value) {
    return value.value.has_value();
}

/// Writes the fields of an object as describe() names them.
struct FieldWriter : NoFields {
    explicit FieldWriter(Json& written) : json(written) {}

    Json& json;

    void type(const Word& word) { json[kTypeKey] = word.name; }
    void type(const Word& word, const Word& otherwise, bool flag) { type(flag ? word : otherwise); }
    void required(const Word& word, const auto& value, const auto&...) {
        json[word.name] = toJson(value);
    }
    void optional(const Word& word, const auto& value, const auto&...) {
        if (isGiven(value)) {
            json[word.name] = toJson(value);
        }
    }
    template <class Enum>
    void optional(const Word& word, const std::optional<Enum>& value, const Words& rule) {
        if (value) {
            json[word.name] = std::string(rule.words[static_cast<std::size_t>(*value)]);
        }
    }
    void oneOf(Region& region, std::string_view) {
        std::visit([this](auto& shape) { describe(*this, shape); }, region);
    }
    void list(const Word& word, const auto& items, std::size_t) {
        for (const auto& item : items) {
            json[word.name].push_back(toJson(item));
        }
    }
    void param(const Word& nameWord, const std::string& name, const Word& valueWord,
               const ParamValue& value) {
        json[nameWord.name] = name;
        json[valueWord.name] = toJson(value);
    }
    void action(const Word&, SessionAction& action) {
        std::visit([this](auto& event) { describe(*this, event); }, action);
    }
};

template <class Described, class... Rule>
requires requires(FieldWriter& fields, Described item, Rule... rule) {
    describe(fields, item, rule...);
}
Json toJson(Described item, const Rule&... rule) {
    Json json = Json::object();
    FieldWriter fields(json);
    describe(fields, item, rule...);
    return json;
}

/// Whether its name still says what the session starts with.
bool keepsMaterial(const Session& session) {
    if (session.material.empty()) {
        return false;
    }
    const std::vector<Material>& all = builtinMaterials();
    const auto found = std::ranges::find(all, session.material, &Material::name);
    return found != all.end() && isMadeOf(session.params, *found) &&
           (session.colors.any() || !found->colors.any());
}

/// Writes a session or a material, with a line for each key, each box, event and source.
class DocumentWriter : public NoFields {
  public:
    std::string text() const { return text_ + "\n}\n"; }

    void ignored(const Word&) {}
    void format(const Word& formatWord, const Word& versionWord, const FileFormat& format) {
        line(formatWord, Json(format.name).dump());
        text_ += ", " + field(versionWord, std::to_string(format.version));
    }
    /// That of a file is left out, which may not lie beside the new session: its values are there.
    void material(const Word& word, const Session& session) {
        if (keepsMaterial(session)) {
            line(word, Json(session.material).dump());
        }
    }
    void required(const Word& word, const auto& value, const auto&...) {
        line(word, toJson(value).dump());
    }
    void optional(const Word& word, const auto& value, const auto&...) {
        if (isGiven(value)) {
            line(word, toJson(value).dump());
        }
    }
    void params(const Word& word, const Session& session) {
        line(word, toJson(session.params).dump());
    }
    void list(const Word& word, const auto& items, std::size_t) {
        if (!items.empty()) {
            line(word, linesOf(items));
        }
    }
    void events(const Word& word, const std::vector<SessionEvent>& events, const Limits& steps) {
        line(word, linesOf(events, steps));
    }

  private:
    static std::string field(const Word& word, const std::string& value) {
        return "\"" + std::string(word.name) + "\": " + value;
    }
    void line(const Word& word, const std::string& value) {
        text_ += (text_.empty() ? "{\n  " : ",\n  ") + field(word, value);
    }
    /// A list with one line each.
    template <class Item, class... Rule>
    static std::string linesOf(const std::vector<Item>& items, const Rule&... rule) {
        std::string lines;
        for (const Item& item : items) {
            lines += (lines.empty() ? "\n    " : ",\n    ") + toJson(item, rule...).dump();
        }
        return lines.empty() ? "[]" : "[" + lines + "\n  ]";
    }

    std::string text_;
};

std::filesystem::path seenFrom(const std::filesystem::path& folder,
                               const std::filesystem::path& path) {
    return folder.empty() ? path : path.lexically_proximate(folder);
}

/// With its path from `baseFolder`, where that is given.
ModelReference inFolder(ModelReference model, const std::filesystem::path& baseFolder) {
    if (!model.builtin.empty()) {
        model.path.clear();
    } else {
        model.path = seenFrom(baseFolder, model.path);
    }
    return model;
}

/// JSON is UTF-8, names of files are any bytes.
std::string textOf(Session& session) {
    try {
        DocumentWriter writer;
        describe(writer, session);
        return writer.text();
    } catch (const Json::type_error&) {
        throw InputError(
            "A session can't hold a name that is not UTF-8; rename the model's file and folders.");
    }
}

}  // namespace

std::string formatSession(const Session& session, const std::filesystem::path& baseFolder) {
    Session written = withOrigin(session, Vec3::Zero());
    written.model = inFolder(session.model, baseFolder);
    for (FurtherModel& further : written.moreModels) {
        further.model = inFolder(further.model, baseFolder);
    }
    if (written.task && !written.task->expert.empty()) {
        written.task->expert = seenFrom(baseFolder, written.task->expert);
    }
    return textOf(written);
}

std::string formatMaterial(const Material& material) {
    Material written = material;
    try {
        DocumentWriter writer;
        describe(writer, written);
        return writer.text();
    } catch (const Json::type_error&) {
        throw InputError("A material can't hold a name that is not UTF-8; choose another one.");
    }
}

std::string formatEvent(const SessionEvent& event) {
    return toJson(event, Limits{0, kMaxSteps}).dump();
}

}  // namespace kerf::app
