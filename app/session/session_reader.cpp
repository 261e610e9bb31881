#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "app/files/file_io.h"
#include "app/session/event_table.h"
#include "app/session/session_json.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

using nlohmann::json;

constexpr double kLeastFieldOfView = 1;
constexpr double kLargestFieldOfView = 150;  // [degrees]
constexpr double kLeastSine = 1e-6;          // between the line of sight and the camera's up
constexpr std::size_t kSha256Digits = 64;

/// A value and where it stands in the file: "events[3].a".
struct Node {
    const json* value = nullptr;
    std::string path;
};

[[noreturn]] void fail(const std::string& path, std::string_view problem) {
    throw InputError(path + ": " + std::string(problem));
}

std::string rangeText(const Limits& limits) {
    return " (" + formatNumber(limits.low) + " to " + formatNumber(limits.high) + ")";
}

double readNumber(const Node& node, const Limits& limits) {
    if (!node.value->is_number()) {
        fail(node.path, "expected a number" + rangeText(limits) + ".");
    }
    const double number = node.value->get<double>();
    if (!(number >= limits.low && number <= limits.high)) {
        fail(node.path, formatNumber(number) + " is out of range" + rangeText(limits) + ".");
    }
    return number;
}

Vec3 readVector(const Node& node, const Limits& limits) {
    const json& value = *node.value;
    if (!value.is_array() || value.size() != 3) {
        fail(node.path, "expected three numbers.");
    }
    Vec3 vector;
    for (int i = 0; i < 3; ++i) {
        if (!value[i].is_number()) {
            fail(node.path, "expected three numbers.");
        }
        vector[i] = readNumber({&value[i], node.path + "[" + std::to_string(i) + "]"}, limits);
    }
    return vector;
}

std::string readString(const Node& node) {
    if (!node.value->is_string()) {
        fail(node.path, "expected a text in quotes.");
    }
    return node.value->get<std::string>();
}

ParamValue readParamValue(const Node& node) {
    const json& value = *node.value;
    if (value.is_null()) {
        return std::monostate{};
    }
    if (value.is_number()) {
        return value.get<double>();
    }
    if (value.is_array()) {
        return readVector(node, kCoordinates);
    }
    if (value.is_string()) {
        return value.get<std::string>();
    }
    fail(node.path, "expected a number, three numbers, a text in quotes or null.");
}

void requireKnownParam(const std::string& name, const std::string& path) {
    if (findParam(name) == nullptr) {
        Params scratch;
        fail(path, setParam(scratch, name, std::monostate{}) + ".");
    }
}

void applyParam(Params& params, const std::string& name, const Node& node) {
    const std::string problem = setParam(params, name, readParamValue(node));
    if (!problem.empty()) {
        fail(node.path, problem + ".");
    }
}

std::vector<Node> itemsOf(const Node& list) {
    if (!list.value->is_array()) {
        fail(list.path, "expected a list in brackets.");
    }
    std::vector<Node> items;
    for (const json& item : *list.value) {
        items.push_back({&item, list.path + "[" + std::to_string(items.size()) + "]"});
    }
    return items;
}

void read(const Node& node, bool& flag) {
    if (!node.value->is_boolean()) {
        fail(node.path, "expected true or false.");
    }
    flag = node.value->get<bool>();
}

void read(const Node& node, double& number, const Limits& limits) {
    number = readNumber(node, limits);
}

void read(const Node& node, int& number, const Limits& limits) {
    const double read = readNumber(node, limits);
    if (read != std::floor(read)) {
        fail(node.path, "expected a whole number" + rangeText(limits) + ".");
    }
    number = static_cast<int>(read);
}

void read(const Node& node, Vec3& vector, const Limits& limits) {
    vector = readVector(node, limits);
}

void read(const Node& node, std::string& text, const HexDigits& digits) {
    text = readString(node);
    if (text.size() != digits.count ||
        text.find_first_not_of("0123456789abcdef") != std::string::npos) {
        fail(node.path,
             "expected " + std::to_string(digits.count) + " lower-case hexadecimal digits.");
    }
}

/// Never a file outside the output folder, and none of those that a replay writes itself.
void read(const Node& node, std::string& text, const OutputName&) {
    const std::string name = readString(node);
    const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
    const bool inside = !path.empty() && !path.is_absolute() && path.has_filename() &&
                        *path.begin() != ".." && *path.begin() != ".";
    if (!inside || name.find('\0') != std::string::npos) {
        fail(node.path, "'" + name + "' is not a file inside the output folder; use a plain name.");
    }
    for (const char* own : {kMetricsFile, kSummaryFile, kMeshFile, kHashesFile, kPiecesFile}) {
        if (path == own) {
            fail(node.path, "'" + name + "' is written by the replay itself; use another name.");
        }
    }
    text = path.generic_string();
}

template <class Value>
void read(const Node& node, std::optional<Value>& value, const auto&... limit) {
    read(node, value.emplace(), limit...);
}

/// The keys of one object, also as describe() names them; those that nobody asked for become
/// warnings at the end.
class ObjectReader {
  public:
    explicit ObjectReader(Node node) : node_(std::move(node)) {
        if (!node_.value->is_object()) {
            fail(node_.path.empty() ? "top level" : node_.path, "expected an object in braces.");
        }
    }

    /// Of a key; of the object itself for "".
    std::string path(const std::string& key) const {
        if (key.empty()) {
            return node_.path;
        }
        return node_.path.empty() ? key : node_.path + "." + key;
    }

    std::optional<Node> optional(const std::string& key) {
        known_.insert(key);
        const auto found = node_.value->find(key);
        if (found == node_.value->end()) {
            return std::nullopt;
        }
        return Node{&*found, path(key)};
    }

    Node required(const std::string& key) {
        const std::optional<Node> node = optional(key);
        if (!node) {
            fail(path(key), "this key is missing; add it.");
        }
        return *node;
    }

    void type(const auto&...) {}  // known by now

    void required(const char* key, auto& value, const auto&... limit) {
        read(required(key), value, limit...);
    }

    void optional(const char* key, auto& value, const auto&... limit) {
        if (const auto node = optional(key)) {
            read(*node, value, limit...);
        }
    }

    void either(Region& region, Keys ball, Keys box, std::string_view problem) {
        const bool isBall = hasAnyOf(ball);
        check(isBall != hasAnyOf(box), "", problem);
        region = isBall ? Region(Ball{}) : Region(Bounds{});
    }

    void param(const char* nameKey, std::string& name, const char* valueKey, ParamValue& value) {
        const Node nameNode = required(nameKey);
        const Node valueNode = required(valueKey);
        name = readString(nameNode);
        requireKnownParam(name, nameNode.path);
        Params scratch;
        applyParam(scratch, name, valueNode);
        value = getParam(scratch, name);
    }

    void check(bool holds, const char* key, std::string_view problem) const {
        if (!holds) {
            fail(path(key), problem);
        }
    }

    void warnAboutTheRest(std::vector<std::string>& warnings) const {
        for (const auto& item : node_.value->items()) {
            if (!known_.contains(item.key())) {
                warnings.push_back(path(item.key()) + ": unknown key, ignored.");
            }
        }
    }

  private:
    bool hasAnyOf(Keys keys) {
        return std::ranges::any_of(keys, [this](auto key) { return optional(key).has_value(); });
    }

    Node node_;
    std::set<std::string> known_;
};

void readFormat(ObjectReader& top) {
    const Node format = top.required("format");
    if (readString(format) != "kerf-session") {
        fail(format.path, "expected \"kerf-session\"; this is some other file.");
    }
    const Node version = top.required("version");
    if (!version.value->is_number()) {
        fail(version.path, "expected a number.");
    }
    const double number = version.value->get<double>();
    if (std::floor(number) != 1) {
        fail(version.path,
             "version " + formatNumber(number) + " is not supported; this kerf reads version 1.");
    }
}

ModelReference readModel(const Node& node, const std::filesystem::path& baseFolder,
                         std::vector<std::string>& warnings) {
    ObjectReader object(node);
    const auto builtin = object.optional("builtin");
    const auto path = object.optional("path");
    if (builtin.has_value() == path.has_value()) {
        fail(node.path, "expected either \"builtin\" or \"path\".");
    }
    ModelReference model;
    if (builtin) {
        model.builtin = readString(*builtin);
        const auto& names = builtinModels();
        if (std::find(names.begin(), names.end(), model.builtin) == names.end()) {
            fail(builtin->path, "there is no builtin model '" + model.builtin + "'; there are " +
                                    joined(names, ", ") + ".");
        }
    } else {
        model.path = std::filesystem::absolute(baseFolder / readString(*path)).lexically_normal();
    }
    object.optional("fill_holes", model.fillHoles);
    object.optional("sha256", model.sha256, HexDigits{kSha256Digits});
    object.warnAboutTheRest(warnings);
    return model;
}

Placement readPlacement(const Node& node, std::vector<std::string>& warnings) {
    ObjectReader object(node);
    Placement placement;
    describe(object, placement);
    object.warnAboutTheRest(warnings);
    return placement;
}

Params readParams(const Node& node) {
    ObjectReader object(node);
    Params params;
    for (const auto& item : node.value->items()) {
        const std::string path = object.path(item.key());
        requireKnownParam(item.key(), path);
        applyParam(params, item.key(), {&item.value(), path});
    }
    return params;
}

std::vector<StaticBox> readBoxes(const Node& node, std::vector<std::string>& warnings) {
    const std::vector<Node> items = itemsOf(node);
    if (items.size() > kMostBoxes) {
        fail(node.path, "at most " + std::to_string(kMostBoxes) + " boxes.");
    }
    std::vector<StaticBox> boxes;
    for (const Node& item : items) {
        ObjectReader object(item);
        describe(object, boxes.emplace_back());
        object.warnAboutTheRest(warnings);
    }
    return boxes;
}

/// What a type of events is called, and an event of it before its fields are read.
struct EventType {
    std::string name;
    SessionAction blank;
};

/// Collects the types of one kind of event.
template <class Event>
struct TypeCollector {
    Event& event;
    std::vector<EventType>& types;

    void type(const char* name) { types.push_back({name, event}); }
    void type(const char* name, const char* otherwise, bool& flag) {
        flag = true;
        type(name);
        flag = false;
        type(otherwise);
    }
    void required(const auto&...) {}
    void optional(const auto&...) {}
    void either(const Region&, Keys, Keys, std::string_view) {}
    void param(const auto&...) {}
    void check(const auto&...) {}
};

std::vector<EventType> collectTypes() {
    std::vector<EventType> types;
    forEachKind(std::type_identity<SessionAction>{}, [&](auto event) {
        TypeCollector<decltype(event)> collector{event, types};
        describe(collector, event);
    });
    return types;
}

SessionAction readAction(ObjectReader& object) {
    static const std::vector<EventType> types = collectTypes();
    const Node type = object.required("type");
    const std::string name = readString(type);
    const auto found = std::ranges::find(types, name, &EventType::name);
    if (found == types.end()) {
        fail(type.path, "there is no event type '" + name + "'; there are " +
                            joined(types, ", ", &EventType::name) + ".");
    }
    SessionAction action = found->blank;
    std::visit([&](auto& event) { describe(object, event); }, action);
    return action;
}

std::vector<SessionEvent> readEvents(const Node& node, int steps,
                                     std::vector<std::string>& warnings) {
    std::vector<SessionEvent> events;
    for (const Node& item : itemsOf(node)) {
        ObjectReader object(item);
        SessionEvent& event = events.emplace_back();
        object.required("step", event.step, Limits{0, double(steps)});
        event.action = readAction(object);
        event.number = static_cast<int>(events.size()) - 1;
        object.warnAboutTheRest(warnings);
    }
    const auto earlier = [](const SessionEvent& a, const SessionEvent& b) {
        return a.step < b.step;
    };
    std::stable_sort(events.begin(), events.end(), earlier);
    return events;
}

Vec3 readColor(const Node& node) {
    Vec3 color = readVector(node, within(1));
    if (color.minCoeff() < 0) {
        fail(node.path, "expected red, green and blue from 0 to 1.");
    }
    return color;
}

/// The camera, and beside it the colours.
void readView(const Node& node, Session& session) {
    ObjectReader object(node);
    render::Camera camera;
    object.required("eye", camera.eye, kCoordinates);
    object.required("target", camera.target, kCoordinates);
    object.optional("up", camera.up, kCoordinates);
    object.optional("fov_y", camera.fovY, Limits{kLeastFieldOfView, kLargestFieldOfView});
    object.optional("orthographic", camera.orthographic);
    if (const auto skin = object.optional("skin")) {
        session.colors.skin = readColor(*skin);
    }
    if (const auto flesh = object.optional("flesh")) {
        session.colors.flesh = readColor(*flesh);
    }
    const Vec3 forward = camera.target - camera.eye;
    if (forward.norm() == 0) {
        fail(node.path, "eye and target are the same point.");
    }
    if (forward.cross(camera.up).norm() < kLeastSine * forward.norm() * camera.up.norm() ||
        camera.up.norm() == 0) {
        fail(object.path("up"), "up must not point along the line of sight.");
    }
    object.warnAboutTheRest(session.warnings);
    session.view = camera;
}

/// The text of a value as JSON; a word that is none as a text.
json parseValue(const std::string& text) {
    const bool isWord = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '-';
    });
    return isWord && !json::accept(text) ? json(text) : parseJson(text);
}

}  // namespace

void setParamFromText(Params& params, const std::string& name, const std::string& value) {
    requireKnownParam(name, "'" + name + "'");
    try {
        const json parsed = parseValue(value);
        applyParam(params, name, {&parsed, name});
    } catch (const InputError& error) {
        const std::string problem = error.what();
        throw InputError(problem.starts_with(name) ? problem : name + ": " + problem);
    }
}

Session parseSession(const std::string& text, const std::filesystem::path& baseFolder) {
    const json document = parseJson(text);
    ObjectReader top({&document, ""});
    readFormat(top);
    Session session;
    session.model = readModel(top.required("model"), baseFolder, session.warnings);
    if (const auto placement = top.optional("placement")) {
        session.placement = readPlacement(*placement, session.warnings);
    }
    if (const auto params = top.optional("params")) {
        session.params = readParams(*params);
    }
    if (const auto boxes = top.optional("boxes")) {
        session.boxes = readBoxes(*boxes, session.warnings);
    }
    top.required("steps", session.steps, Limits{1, kMaxSteps});
    if (const auto events = top.optional("events")) {
        session.events = readEvents(*events, session.steps, session.warnings);
    }
    if (const auto view = top.optional("view")) {
        readView(*view, session);
    }
    top.warnAboutTheRest(session.warnings);
    return session;
}

Session readSession(const std::filesystem::path& file) {
    const std::string text = readInputFile(file, kMaxSessionBytes);
    try {
        Session session = parseSession(text, std::filesystem::absolute(file).parent_path());
        session.fileName = file.filename().string();
        for (std::string& warning : session.warnings) {
            warning.insert(0, session.fileName + ": ");
        }
        return session;
    } catch (const InputError& error) {
        throw InputError(file.filename().string() + ": " + error.what());
    }
}

}  // namespace kerf::app
