#include <algorithm>
#include <cmath>
#include <set>

#include "app/files/export.h"
#include "app/files/file_io.h"
#include "app/session/session.h"
#include "app/session/session_json.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

using nlohmann::json;

constexpr double kLeastScale = 1e-6;
constexpr double kLargestScale = 1e6;
constexpr double kLargestTurn = 36000;  // [degrees]
constexpr double kLeastFieldOfView = 1;
constexpr double kLargestFieldOfView = 150;  // [degrees]
constexpr double kLeastSine = 1e-6;          // between the line of sight and the camera's up
constexpr int kLargestHand = 99;
constexpr double kLeastRadius = 1e-9;  // [m]
constexpr std::size_t kSha256Digits = 64;
constexpr std::size_t kStateHashDigits = 16;

/// A value and where it stands in the file: "events[3].a".
struct Node {
    const json* value = nullptr;
    std::string place;
};

[[noreturn]] void fail(const std::string& place, const std::string& problem) {
    throw InputError(place + ": " + problem);
}

std::string rangeText(double low, double high) {
    return " (" + formatNumber(low) + " to " + formatNumber(high) + ")";
}

double readNumber(const Node& node, double low, double high) {
    if (!node.value->is_number()) {
        fail(node.place, "expected a number" + rangeText(low, high) + ".");
    }
    const double number = node.value->get<double>();
    if (!(number >= low && number <= high)) {
        fail(node.place, formatNumber(number) + " is out of range" + rangeText(low, high) + ".");
    }
    return number;
}

int readInteger(const Node& node, int low, int high) {
    const double number = readNumber(node, low, high);
    if (number != std::floor(number)) {
        fail(node.place, "expected a whole number" + rangeText(low, high) + ".");
    }
    return static_cast<int>(number);
}

Vec3 readVector(const Node& node, double limit) {
    const json& value = *node.value;
    if (!value.is_array() || value.size() != 3) {
        fail(node.place, "expected three numbers.");
    }
    Vec3 vector;
    for (int i = 0; i < 3; ++i) {
        if (!value[i].is_number()) {
            fail(node.place, "expected three numbers.");
        }
        vector[i] =
            readNumber({&value[i], node.place + "[" + std::to_string(i) + "]"}, -limit, limit);
    }
    return vector;
}

std::string readString(const Node& node) {
    if (!node.value->is_string()) {
        fail(node.place, "expected a text in quotes.");
    }
    return node.value->get<std::string>();
}

bool readBoolean(const Node& node) {
    if (!node.value->is_boolean()) {
        fail(node.place, "expected true or false.");
    }
    return node.value->get<bool>();
}

/// The keys of one object; those that nobody asked for become warnings at the end.
class ObjectReader {
  public:
    explicit ObjectReader(Node node) : node_(std::move(node)) {
        if (!node_.value->is_object()) {
            fail(node_.place.empty() ? "top level" : node_.place, "expected an object in braces.");
        }
    }

    std::string place(const std::string& key) const {
        return node_.place.empty() ? key : node_.place + "." + key;
    }

    std::optional<Node> optional(const std::string& key) {
        known_.insert(key);
        const auto found = node_.value->find(key);
        if (found == node_.value->end()) {
            return std::nullopt;
        }
        return Node{&*found, place(key)};
    }

    Node required(const std::string& key) {
        const std::optional<Node> node = optional(key);
        if (!node) {
            fail(place(key), "this key is missing; add it.");
        }
        return *node;
    }

    void warnAboutTheRest(std::vector<std::string>& warnings) const {
        for (const auto& item : node_.value->items()) {
            if (!known_.contains(item.key())) {
                warnings.push_back(place(item.key()) + ": unknown key, ignored.");
            }
        }
    }

  private:
    Node node_;
    std::set<std::string> known_;
};

void readFormat(ObjectReader& top) {
    const Node format = top.required("format");
    if (readString(format) != "kerf-session") {
        fail(format.place, "expected \"kerf-session\"; this is some other file.");
    }
    const Node version = top.required("version");
    if (!version.value->is_number()) {
        fail(version.place, "expected a number.");
    }
    const double number = version.value->get<double>();
    if (std::floor(number) != 1) {
        fail(version.place,
             "version " + formatNumber(number) + " is not supported; this kerf reads version 1.");
    }
}

std::string readHexadecimal(const Node& node, std::size_t digits) {
    std::string text = readString(node);
    if (text.size() != digits || text.find_first_not_of("0123456789abcdef") != std::string::npos) {
        fail(node.place, "expected " + std::to_string(digits) + " lower-case hexadecimal digits.");
    }
    return text;
}

ModelReference readModel(const Node& node, const std::filesystem::path& baseFolder,
                         std::vector<std::string>& warnings) {
    ObjectReader object(node);
    const auto builtin = object.optional("builtin");
    const auto path = object.optional("path");
    const auto digest = object.optional("sha256");
    if (builtin.has_value() == path.has_value()) {
        fail(node.place, "expected either \"builtin\" or \"path\".");
    }
    ModelReference model;
    if (builtin) {
        model.builtin = readString(*builtin);
        const auto& names = builtinModels();
        if (std::find(names.begin(), names.end(), model.builtin) == names.end()) {
            fail(builtin->place, "there is no builtin model '" + model.builtin + "'; there are " +
                                     joined(names, ", ") + ".");
        }
    } else {
        model.path = std::filesystem::absolute(baseFolder / readString(*path)).lexically_normal();
    }
    if (const auto fill = object.optional("fill_holes")) {
        model.fillHoles = readBoolean(*fill);
    }
    if (digest) {
        model.sha256 = readHexadecimal(*digest, kSha256Digits);
    }
    object.warnAboutTheRest(warnings);
    return model;
}

Placement readPlacement(const Node& node, std::vector<std::string>& warnings) {
    ObjectReader object(node);
    Placement placement;
    if (const auto scale = object.optional("scale")) {
        placement.scale = readNumber(*scale, kLeastScale, kLargestScale);
    }
    if (const auto rotate = object.optional("rotate")) {
        placement.rotate = readVector(*rotate, kLargestTurn);
    }
    if (const auto translate = object.optional("translate")) {
        placement.translate = readVector(*translate, kMaxSessionCoordinate);
    }
    object.warnAboutTheRest(warnings);
    return placement;
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
        return readVector(node, kMaxSessionCoordinate);
    }
    if (value.is_string()) {
        return value.get<std::string>();
    }
    fail(node.place, "expected a number, three numbers, a text in quotes or null.");
}

void requireKnownParam(const std::string& name, const std::string& place) {
    if (findParam(name) == nullptr) {
        Params scratch;
        fail(place, setParam(scratch, name, std::monostate{}) + ".");
    }
}

void applyParam(Params& params, const std::string& name, const Node& node) {
    const std::string problem = setParam(params, name, readParamValue(node));
    if (!problem.empty()) {
        fail(node.place, problem + ".");
    }
}

Params readParams(const Node& node) {
    ObjectReader object(node);
    Params params;
    for (const auto& item : node.value->items()) {
        const std::string place = object.place(item.key());
        requireKnownParam(item.key(), place);
        applyParam(params, item.key(), {&item.value(), place});
    }
    return params;
}

MoveBlade readBlade(ObjectReader& object) {
    MoveBlade move;
    const Node a = object.required("a");
    move.blade.a = readVector(a, kMaxSessionCoordinate);
    move.blade.b = readVector(object.required("b"), kMaxSessionCoordinate);
    if (move.blade.a == move.blade.b) {
        fail(a.place, "a and b are the same point; a blade needs a length.");
    }
    return move;
}

SetParam readSet(ObjectReader& object) {
    const Node name = object.required("name");
    const Node value = object.required("value");
    SetParam set{readString(name), {}};
    requireKnownParam(set.name, name.place);
    Params scratch;
    applyParam(scratch, set.name, value);
    set.value = getParam(scratch, set.name);
    if (const auto continues = object.optional("continues")) {
        set.continues = readBoolean(*continues);
    }
    return set;
}

int readHand(ObjectReader& object) {
    const auto hand = object.optional("hand");
    return hand ? readInteger(*hand, 0, kLargestHand) : 0;
}

Grab readGrab(ObjectReader& object) {
    const int hand = readHand(object);
    const Vec3 at = readVector(object.required("at"), kMaxSessionCoordinate);
    return {hand, at, readNumber(object.required("radius"), kLeastRadius, kMaxSessionCoordinate)};
}

Drag readDrag(ObjectReader& object) {
    const int hand = readHand(object);
    return {hand, readVector(object.required("to"), kMaxSessionCoordinate)};
}

/// A ball ("center", "radius") or a box ("low", "high"), but not some of each.
Region readRegion(ObjectReader& object, const Node& event) {
    const bool ball = object.optional("center") || object.optional("radius");
    const bool box = object.optional("low") || object.optional("high");
    if (ball == box) {
        fail(event.place,
             "expected either a ball (\"center\", \"radius\") or a box (\"low\", \"high\").");
    }
    if (ball) {
        const Vec3 at = readVector(object.required("center"), kMaxSessionCoordinate);
        return Ball{at, readNumber(object.required("radius"), kLeastRadius, kMaxSessionCoordinate)};
    }
    const Node low = object.required("low");
    const Bounds bounds{readVector(low, kMaxSessionCoordinate),
                        readVector(object.required("high"), kMaxSessionCoordinate)};
    if ((bounds.low.array() > bounds.high.array()).any()) {
        fail(low.place, "a box needs low to be no higher than high, in each direction.");
    }
    return bounds;
}

Pin readPin(ObjectReader& object, const Node& event, bool pinned) {
    Pin pin{readRegion(object, event), pinned};
    if (const auto continues = object.optional("continues")) {
        pin.continues = readBoolean(*continues);
    }
    return pin;
}

/// "center", "size" and, where the box is turned, "rotate".
StaticBox readBox(ObjectReader& object) {
    StaticBox box;
    box.center = readVector(object.required("center"), kFarthestBox);
    const Node size = object.required("size");
    box.size = readVector(size, kLargestBoxSize);
    if (box.size.minCoeff() < kLeastBoxSize) {
        fail(size.place,
             "each side of a box must be at least " + formatNumber(kLeastBoxSize) + " m long.");
    }
    if (const auto rotate = object.optional("rotate")) {
        box.rotate = readVector(*rotate, kLargestBoxTurn);
    }
    return box;
}

std::vector<StaticBox> readBoxes(const Node& node, std::vector<std::string>& warnings) {
    if (!node.value->is_array()) {
        fail(node.place, "expected a list in brackets.");
    }
    if (node.value->size() > kMostBoxes) {
        fail(node.place, "at most " + std::to_string(kMostBoxes) + " boxes.");
    }
    std::vector<StaticBox> boxes;
    for (std::size_t i = 0; i < node.value->size(); ++i) {
        ObjectReader object({&(*node.value)[i], node.place + "[" + std::to_string(i) + "]"});
        boxes.push_back(readBox(object));
        object.warnAboutTheRest(warnings);
    }
    return boxes;
}

int readBoxIndex(ObjectReader& object) {
    return readInteger(object.required("box"), 0, static_cast<int>(kMostBoxes) - 1);
}

ChangeBox readChangeBox(ObjectReader& object) {
    ChangeBox change{readBoxIndex(object), readBox(object)};
    if (const auto continues = object.optional("continues")) {
        change.continues = readBoolean(*continues);
    }
    return change;
}

/// A file below the output folder: never outside, and none of those that a replay writes itself.
std::string readOutputName(const Node& node) {
    const std::string name = readString(node);
    const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
    const bool inside = !path.empty() && !path.is_absolute() && path.has_filename() &&
                        *path.begin() != ".." && *path.begin() != ".";
    if (!inside || name.find('\0') != std::string::npos) {
        fail(node.place,
             "'" + name + "' is not a file inside the output folder; use a plain name.");
    }
    for (const char* own : {kMetricsFile, kSummaryFile, kMeshFile}) {
        if (path == own) {
            fail(node.place, "'" + name + "' is written by the replay itself; use another name.");
        }
    }
    return path.generic_string();
}

ScreenshotEvent readScreenshot(ObjectReader& object) {
    const Node file = object.required("file");
    ScreenshotEvent event;
    event.file = readOutputName(file);
    if (std::filesystem::path(event.file).extension() != ".png") {
        fail(file.place, "'" + event.file + "' must end in .png.");
    }
    if (const auto width = object.optional("width")) {
        event.width = readInteger(*width, 1, kMaxPictureSize);
    }
    if (const auto height = object.optional("height")) {
        event.height = readInteger(*height, 1, kMaxPictureSize);
    }
    return event;
}

ExportEvent readExport(ObjectReader& object) {
    const Node file = object.required("file");
    ExportEvent event{readOutputName(file), false};
    if (!meshFormatOf(event.file)) {
        fail(file.place, "'" + event.file + "' must end in .ply, .obj, .stl, .glb or .gltf.");
    }
    if (const auto perPiece = object.optional("per_piece")) {
        event.filePerPiece = readBoolean(*perPiece);
    }
    return event;
}

CheckEvent readCheck(ObjectReader& object, const std::string& place) {
    CheckEvent event;
    if (const auto hash = object.optional("hash")) {
        event.hash = readHexadecimal(*hash, kStateHashDigits);
    }
    if (const auto pieces = object.optional("pieces")) {
        event.pieces = readInteger(*pieces, 1, kMaxSteps);
    }
    if (!event.hash && !event.pieces) {
        fail(place, "a check needs \"hash\" or \"pieces\".");
    }
    return event;
}

SessionAction readAction(ObjectReader& object, const Node& event) {
    const Node type = object.required("type");
    const std::string name = readString(type);
    if (name == "blade") return readBlade(object);
    if (name == "lift") return LiftBlade{};
    if (name == "set") return readSet(object);
    if (name == "screenshot") return readScreenshot(object);
    if (name == "export") return readExport(object);
    if (name == "check") return readCheck(object, event.place);
    if (name == "grab") return readGrab(object);
    if (name == "drag") return readDrag(object);
    if (name == "release") return Release{readHand(object)};
    if (name == "pin" || name == "unpin") {
        return readPin(object, event, name == "pin");
    }
    if (name == "add_box") return AddBox{readBox(object)};
    if (name == "change_box") return readChangeBox(object);
    if (name == "remove_box") return RemoveBox{readBoxIndex(object)};
    if (name == "restart") return Restart{};
    if (name == "undo") return Undo{};
    if (name == "redo") return Redo{};
    fail(type.place, "there is no event type '" + name +
                         "'; there are blade, lift, set, grab, drag, release, pin, unpin, add_box, "
                         "change_box, remove_box, restart, undo, redo, screenshot, export, "
                         "check.");
}

std::vector<SessionEvent> readEvents(const Node& node, int steps,
                                     std::vector<std::string>& warnings) {
    if (!node.value->is_array()) {
        fail(node.place, "expected a list in brackets.");
    }
    std::vector<SessionEvent> events;
    for (std::size_t i = 0; i < node.value->size(); ++i) {
        const Node event{&(*node.value)[i], node.place + "[" + std::to_string(i) + "]"};
        ObjectReader object(event);
        const int step = readInteger(object.required("step"), 0, steps);
        events.push_back({step, readAction(object, event), static_cast<int>(i)});
        object.warnAboutTheRest(warnings);
    }
    const auto earlier = [](const SessionEvent& a, const SessionEvent& b) {
        return a.step < b.step;
    };
    std::stable_sort(events.begin(), events.end(), earlier);
    return events;
}

Vec3 readColor(const Node& node) {
    Vec3 color = readVector(node, 1);
    if (color.minCoeff() < 0) {
        fail(node.place, "expected red, green and blue from 0 to 1.");
    }
    return color;
}

/// The camera, and beside it the colours.
void readView(const Node& node, Session& session) {
    ObjectReader object(node);
    render::Camera camera;
    camera.eye = readVector(object.required("eye"), kMaxSessionCoordinate);
    camera.target = readVector(object.required("target"), kMaxSessionCoordinate);
    if (const auto up = object.optional("up")) {
        camera.up = readVector(*up, kMaxSessionCoordinate);
    }
    if (const auto fov = object.optional("fov_y")) {
        camera.fovY = readNumber(*fov, kLeastFieldOfView, kLargestFieldOfView);
    }
    if (const auto orthographic = object.optional("orthographic")) {
        camera.orthographic = readBoolean(*orthographic);
    }
    if (const auto skin = object.optional("skin")) {
        session.colors.skin = readColor(*skin);
    }
    if (const auto flesh = object.optional("flesh")) {
        session.colors.flesh = readColor(*flesh);
    }
    const Vec3 forward = camera.target - camera.eye;
    if (forward.norm() == 0) {
        fail(node.place, "eye and target are the same point.");
    }
    if (forward.cross(camera.up).norm() < kLeastSine * forward.norm() * camera.up.norm() ||
        camera.up.norm() == 0) {
        fail(object.place("up"), "up must not point along the line of sight.");
    }
    object.warnAboutTheRest(session.warnings);
    session.view = camera;
}

}  // namespace

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
    session.steps = readInteger(top.required("steps"), 1, kMaxSteps);
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
