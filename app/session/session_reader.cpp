#include <cctype>

#include "app/files/import/builtin_models.h"
#include "app/files/io/file_io.h"
#include "app/session/session.h"
#include "app/session/session_json.h"
#include "app/session/session_table.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

using InputJson = nlohmann::json;

/// A value and where it stands in the file: "events[3].a".
struct Node {
    const InputJson* value = nullptr;
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
    const InputJson& value = *node.value;
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

ParamValue readParamValue(const std::string& name, const Node& node) {
    const InputJson& value = *node.value;
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
    // The parameter itself says what it takes, where it gets something else.
    const ParamInfo* const info = findParam(name);
    const bool takesVector = info != nullptr && info->type == ParamType::vector;
    Params scratch;
    fail(node.path, setParam(scratch, shortened(name),
                             takesVector ? ParamValue(0.0) : ParamValue(Vec3(0, 0, 0))) +
                        ".");
}

void requireKnownParam(const std::string& name, const std::string& path) {
    if (findParam(name) == nullptr) {
        Params scratch;
        fail(path, setParam(scratch, shortened(name), std::monostate{}) + ".");
    }
}

void applyParam(Params& params, const std::string& name, const Node& node) {
    const std::string problem = setParam(params, name, readParamValue(name, node));
    if (!problem.empty()) {
        fail(node.path, problem + ".");
    }
}

void requireList(const Node& node) {
    if (!node.value->is_array()) {
        fail(node.path, "expected a list in brackets.");
    }
}

/// Reads one item after the other: a list of millions that is wrong is so from its first item on.
template <class Read>
void forEachItem(const Node& list, Read read) {
    requireList(list);
    std::size_t number = 0;
    for (const InputJson& item : *list.value) {
        read(Node{&item, list.path + "[" + std::to_string(number++) + "]"});
    }
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

template <class Item>
void read(const Node& node, std::vector<Item>& items, const Limits& limits) {
    forEachItem(node, [&](const Node& item) { read(item, items.emplace_back(), limits); });
}

void read(const Node& node, std::string& text, const HexDigits& digits) {
    text = readString(node);
    if (text.size() != digits.count ||
        text.find_first_not_of("0123456789abcdef") != std::string::npos) {
        fail(node.path,
             "expected " + std::to_string(digits.count) + " lower-case hexadecimal digits.");
    }
}

void requireInsideOutputFolder(const Node& node, const std::string& name) {
    const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
    if (!isNameInside(name)) {
        fail(node.path,
             "'" + shortened(name) + "' is not a file inside the output folder; use a plain name.");
    }
    for (const char* own : kReplayFiles) {
        if (*path.begin() == own) {
            fail(node.path,
                 "'" + shortened(name) + "' is written by the replay itself; use another name.");
        }
    }
}

/// ".ply, .obj or .stl".
std::string alternatives(std::span<const std::string_view> words) {
    const std::string first = joined(words.first(words.size() - 1), ", ");
    return first + (first.empty() ? "" : " or ") + std::string(words.back());
}

void requireEnding(const Node& node, const std::string& name,
                   const std::vector<std::string_view>& endings) {
    const std::string ending = lowerCase(std::filesystem::path(name).extension().string());
    if (std::ranges::find(endings, ending) == endings.end()) {
        fail(node.path, "'" + shortened(name) + "' must end in " + alternatives(endings) + ".");
    }
}

void read(const Node& node, std::string& text, const OutputName& rule) {
    const std::string name = readString(node);
    requireInsideOutputFolder(node, name);
    requireEnding(node, name, rule.endings);
    text = std::filesystem::path(name).lexically_normal().generic_string();
}

void read(const Node& node, std::string& text, const BuiltinName&) {
    text = readString(node);
    const auto& names = builtinModels();
    if (std::ranges::find(names, text) == names.end()) {
        fail(node.path, "there is no builtin model '" + shortened(text) + "'; there are " +
                            joined(names, ", ") + ".");
    }
}

void read(const Node& node, std::filesystem::path& path, const ModelPath&) {
    const std::string name = readString(node);
    if (const std::string problem = problemWithPath(name); !problem.empty()) {
        fail(node.path, problem);
    }
    path = name;
}

void read(const Node& node, std::string& text, const ShortText& rule) {
    text = readString(node);
    if (text.size() > rule.most) {
        fail(node.path, "at most " + std::to_string(rule.most) + " bytes.");
    }
}

void requireOneOf(const Node& node, const std::string& text, const Words& rule) {
    if (std::ranges::find(rule.words, text) == rule.words.end()) {
        fail(node.path, "'" + shortened(text) + "' is none of " + joined(rule.words, ", ") + ".");
    }
}

void read(const Node& node, std::vector<std::string>& texts, const Words& rule) {
    forEachItem(node, [&](const Node& item) {
        texts.push_back(readString(item));
        requireOneOf(item, texts.back(), rule);
    });
}

template <class Enum>
requires std::is_enum_v<Enum>
void read(const Node& node, Enum& value, const Words& rule) {
    const std::string text = readString(node);
    requireOneOf(node, text, rule);
    value = static_cast<Enum>(std::ranges::find(rule.words, text) - rule.words.begin());
}

template <class Value>
void read(const Node& node, std::optional<Value>& value, const auto&... limit) {
    read(node, value.emplace(), limit...);
}

/// Sessions of before may name a solver, and a parameter of it, that are no longer there.
bool isFormerParam(std::string_view name) {
    return name == "true_modulus";
}

void warnAboutFormerSolver(const Node& value, std::vector<std::string>& warnings) {
    if (value.value->is_string() && *value.value == kFormerSolver) {
        warnings.push_back(value.path + ": \"" + std::string(kFormerSolver) +
                           "\" is no longer there, \"implicit\" takes its place.");
    }
}

void readParams(const Node& node, Params& params, std::vector<std::string>& warnings) {
    if (!node.value->is_object()) {
        fail(node.path, "expected an object in braces.");
    }
    for (const auto& item : node.value->items()) {
        const std::string path = node.path + "." + shortened(item.key());
        if (isFormerParam(item.key())) {
            warnings.push_back(path +
                               ": no longer there, ignored; bodies are always as stiff as "
                               "youngs_modulus says.");
            continue;
        }
        warnAboutFormerSolver({&item.value(), path}, warnings);
        requireKnownParam(item.key(), path);
        applyParam(params, item.key(), {&item.value(), path});
    }
}

void requireKnownVersion(const Node& node, int known) {
    const double number = node.value->get<double>();
    if (std::floor(number) != known) {
        fail(node.path, "version " + formatNumber(number) +
                            " is not supported; this kerf reads version " + std::to_string(known) +
                            ".");
    }
}

Material readMaterialOf(const Node& node, const std::filesystem::path& baseFolder) {
    const std::string text = readString(node);
    if (const std::string problem = problemWithPath(text); !problem.empty()) {
        fail(node.path, problem);
    }
    try {
        return findMaterial(text, baseFolder);
    } catch (const InputError& error) {
        fail(node.path, error.what());
    }
}

/// What a type of events is called, and an event of it before its fields are read.
struct EventType {
    std::string name;
    SessionAction blank;
};

/// Collects the types of one kind of event.
template <class Event>
struct TypeCollector : NoFields {
    TypeCollector(Event& blank, std::vector<EventType>& collected)
        : event(blank), types(collected) {}

    Event& event;
    std::vector<EventType>& types;

    void type(const Word& word) { types.push_back({word.name, event}); }
    void type(const Word& word, const Word& otherwise, bool& flag) {
        flag = true;
        type(word);
        flag = false;
        type(otherwise);
    }
};

const std::vector<EventType>& eventTypes() {
    static const std::vector<EventType> types = [] {
        std::vector<EventType> collected;
        forEachKind(std::type_identity<SessionAction>{}, [&](auto event) {
            TypeCollector collector(event, collected);
            describe(collector, event);
        });
        return collected;
    }();
    return types;
}

/// Collects the keys of a ball or a box.
struct KeyCollector : NoFields {
    std::vector<std::string> keys;

    void required(const Word& word, const auto&...) { keys.emplace_back(word.name); }
};

template <class Shape>
std::vector<std::string> keysOf(Shape shape) {
    KeyCollector collector;
    describe(collector, shape);
    return collector.keys;
}

/// The keys of one object, as describe() names them; those that nobody asked for become warnings
/// at the end.
class ObjectReader : public NoFields {
  public:
    /// Files that it names are relative to `baseFolder`.
    ObjectReader(Node node, std::vector<std::string>& warnings,
                 std::filesystem::path baseFolder = {})
        : node_(std::move(node)), warnings_(&warnings), baseFolder_(std::move(baseFolder)) {
        if (!node_.value->is_object()) {
            fail(node_.path.empty() ? "top level" : node_.path, "expected an object in braces.");
        }
    }

    void required(const Word& word, auto& value, const auto&... rule) {
        readField(require(word.name), value, rule...);
    }

    void optional(const Word& word, auto& value, const auto&... rule) {
        if (const auto node = find(word.name)) {
            readField(*node, value, rule...);
        }
    }

    void exactlyOneOf(Keys keys, std::string_view problem) {
        check(std::ranges::count_if(keys, [this](auto key) { return has(key); }) == 1, "", problem);
    }

    void atLeastOneOf(Keys keys, std::string_view problem) { check(hasAnyOf(keys), "", problem); }

    void oneOf(Region& region, std::string_view problem) {
        const bool isBall = hasAnyOf(keysOf(Ball{}));
        check(isBall != hasAnyOf(keysOf(Bounds{})), "", problem);
        region = isBall ? Region(Ball{}) : Region(Bounds{});
        std::visit([this](auto& shape) { describe(*this, shape); }, region);
    }

    void param(const Word& nameWord, std::string& name, const Word& valueWord, ParamValue& value) {
        const Node nameNode = require(nameWord.name);
        const Node valueNode = require(valueWord.name);
        name = readString(nameNode);
        requireKnownParam(name, nameNode.path);
        warnAboutFormerSolver(valueNode, *warnings_);
        Params scratch;
        applyParam(scratch, name, valueNode);
        value = getParam(scratch, name);
    }

    void check(bool holds, const char* key, std::string_view problem) const {
        if (!holds) {
            fail(path(key), problem);
        }
    }

    void ignored(const Word& word) { find(word.name); }

    void format(const Word& formatWord, const Word& versionWord, const FileFormat& known) {
        const Node format = require(formatWord.name);
        if (readString(format) != known.name) {
            fail(format.path,
                 "expected \"" + std::string(known.name) + "\"; this is some other file.");
        }
        const Node version = require(versionWord.name);
        if (!version.value->is_number()) {
            fail(version.path, "expected a number.");
        }
        requireKnownVersion(version, known.version);
    }

    void material(const Word& word, Session& session) {
        if (const auto node = find(word.name)) {
            material_ = readMaterialOf(*node, baseFolder_);
            applyMaterial(session.params, *material_);
            const std::string text = readString(*node);
            session.material = namesMaterialFile(text) ? "" : text;
        }
    }

    void params(const Word& word, Session& session) {
        if (const auto node = find(word.name)) {
            readParams(*node, session.params, *warnings_);
        }
    }

    template <class Item>
    void list(const Word& word, std::vector<Item>& items, std::size_t most) {
        const auto list = find(word.name);
        if (!list) {
            return;
        }
        requireList(*list);
        check(list->value->size() <= most, word.name,
              "at most " + std::to_string(most) + " " + word.name + ".");
        forEachItem(*list, [&](const Node& item) { readField(item, items.emplace_back()); });
    }

    void events(const Word& word, std::vector<SessionEvent>& events, const Limits& steps) {
        const auto list = find(word.name);
        if (!list) {
            return;
        }
        forEachItem(*list, [&](const Node& item) {
            SessionEvent& event = events.emplace_back();
            event.number = static_cast<int>(events.size()) - 1;
            readField(item, event, steps);
        });
        std::ranges::stable_sort(events, {}, &SessionEvent::step);
    }

    void action(const Word& word, SessionAction& action) {
        const Node type = require(word.name);
        const std::string name = readString(type);
        const auto found = std::ranges::find(eventTypes(), name, &EventType::name);
        if (found == eventTypes().end()) {
            fail(type.path, "there is no event type '" + shortened(name) + "'; there are " +
                                joined(eventTypes(), ", ", &EventType::name) + ".");
        }
        action = found->blank;
        std::visit([this](auto& event) { describe(*this, event); }, action);
    }

    /// The material that it names, if any.
    const std::optional<Material>& material() const { return material_; }

    void warnAboutTheRest() const {
        for (const auto& item : node_.value->items()) {
            if (!known_.contains(item.key())) {
                warnings_->push_back(path(shortened(item.key())) + ": unknown key, ignored.");
            }
        }
    }

  private:
    /// Of a key; of the object itself for "".
    std::string path(const std::string& key) const {
        if (key.empty()) {
            return node_.path;
        }
        return node_.path.empty() ? key : node_.path + "." + key;
    }

    std::optional<Node> find(const std::string& key) {
        known_.insert(key);
        const auto found = node_.value->find(key);
        if (found == node_.value->end()) {
            return std::nullopt;
        }
        return Node{&*found, path(key)};
    }

    Node require(const std::string& key) {
        const std::optional<Node> node = find(key);
        if (!node) {
            fail(path(key), "this key is missing; add it.");
        }
        return *node;
    }

    bool has(const std::string& key) { return find(key).has_value(); }

    bool hasAnyOf(const auto& keys) {
        return std::ranges::any_of(keys, [this](const auto& key) { return has(key); });
    }

    /// A value, or an object that describe() knows.
    template <class Value, class... Rule>
    void readField(const Node& node, Value& value, const Rule&... rule) {
        if constexpr (requires { describe(*this, value, rule...); }) {
            ObjectReader object(node, *warnings_);
            describe(object, value, rule...);
            object.warnAboutTheRest();
        } else if constexpr (requires { describe(*this, value.emplace(), rule...); }) {
            readField(node, value.emplace(), rule...);
        } else {
            read(node, value, rule...);
        }
    }

    Node node_;
    std::vector<std::string>* warnings_;
    std::filesystem::path baseFolder_;
    std::optional<Material> material_;
    std::set<std::string> known_;
};

/// The text of a value as JSON; a word that is none as a text.
InputJson parseValue(const std::string& text) {
    const bool isWord = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '-';
    });
    return isWord && !InputJson::accept(text) ? InputJson(text) : parseJson(text);
}

/// No file can lie in another one.
void requireFilesBesideEachOther(const Session& session) {
    std::set<std::string> names;
    for (const SessionEvent& event : session.events) {
        if (const std::string* file = fileOf(event.action)) {
            names.insert(*file);
        }
    }
    for (const std::string& name : names) {
        const auto inside = names.lower_bound(name + "/");
        if (inside != names.end() && inside->starts_with(name + "/")) {
            fail("events", "'" + shortened(*inside) + "' can't lie in '" + shortened(name) +
                               "', which is a file; use another name.");
        }
    }
}

/// Of two files of one name the earlier is lost.
void warnAboutOneName(Session& session) {
    std::set<std::string> names;
    for (const SessionEvent& event : session.events) {
        const std::string* file = fileOf(event.action);
        if (file != nullptr && !names.insert(*file).second) {
            session.warnings.push_back("events: at step " + std::to_string(event.step) + " " +
                                       shortened(*file) +
                                       " takes the place of an earlier file of that name.");
        }
    }
}

std::filesystem::path absoluteIn(const std::filesystem::path& folder,
                                 const std::filesystem::path& path) {
    return std::filesystem::absolute(folder / path).lexically_normal();
}

void makeAbsolute(ModelReference& model, const std::filesystem::path& baseFolder) {
    if (model.builtin.empty()) {
        model.path = absoluteIn(baseFolder, model.path);
    }
}

/// Throws InputError if the session has no model of that number.
void requireModel(const Session& session, const std::string& path, int model) {
    const int models = static_cast<int>(session.moreModels.size()) + 1;
    if (model >= models) {
        fail(path, "there is no model " + std::to_string(model) + "; the session has " +
                       counted(models, "model", "models") + ", numbered from 0.");
    }
}

void requireModelsOfTask(const Session& session) {
    const Task& task = *session.task;
    requireModel(session, "task.model", task.model);
    requireModel(session, "task.take", task.take.value_or(0));
    for (std::size_t i = 0; i < task.spare.size(); ++i) {
        requireModel(session, "task.spare[" + std::to_string(i) + "]", task.spare[i]);
    }
    if (task.take == task.model || std::ranges::count(task.spare, task.model) > 0) {
        fail("task.model", "it is to be cut, so it can't be spared or taken out.");
    }
}

}  // namespace

void requireModelsOfParams(const Session& session) {
    for (const std::string& name : ownNames(session.params)) {
        requireModel(session, "params." + name, modelOf(name));
    }
}

void setParamFromText(Params& params, const std::string& name, const std::string& value) {
    requireKnownParam(name, "'" + name + "'");
    try {
        const InputJson parsed = parseValue(value);
        applyParam(params, name, {&parsed, name});
    } catch (const InputError& error) {
        const std::string problem = error.what();
        throw InputError(problem.starts_with(name) ? problem : name + ": " + problem);
    }
}

Session parseSession(const std::string& text, const std::filesystem::path& baseFolder) {
    const InputJson document = parseJson(text);
    Session session;
    ObjectReader top({&document, ""}, session.warnings, baseFolder);
    describe(top, session);
    top.warnAboutTheRest();
    if (top.material() && !session.colors.any()) {
        session.colors = top.material()->colors;
    }
    requireFilesBesideEachOther(session);
    warnAboutOneName(session);
    makeAbsolute(session.model, baseFolder);
    for (FurtherModel& further : session.moreModels) {
        makeAbsolute(further.model, baseFolder);
    }
    requireModelsOfParams(session);
    if (session.task) {
        requireModelsOfTask(session);
        if (!session.task->expert.empty()) {
            session.task->expert = absoluteIn(baseFolder, session.task->expert);
        }
    }
    return session;
}

SessionAction parseAction(const std::string& text, std::vector<std::string>& warnings) {
    const InputJson document = parseJson(text);
    const bool named =
        document.is_object() && document.contains(kTypeKey) && document.at(kTypeKey).is_string();
    const std::string path = named ? shortened(document.at(kTypeKey).get<std::string>()) : "";
    SessionAction action;
    ObjectReader event({&document, path}, warnings);
    event.action({kTypeKey, ""}, action);
    event.warnAboutTheRest();
    return action;
}

render::Camera parseCamera(const std::string& text, std::vector<std::string>& warnings) {
    const InputJson document = parseJson(text);
    render::Camera camera;
    ObjectReader view({&document, "view"}, warnings);
    describe(view, camera);
    view.warnAboutTheRest();
    return camera;
}

Material parseMaterial(const std::string& text) {
    const InputJson document = parseJson(text);
    Material material;
    std::vector<std::string> unknownKeys;
    ObjectReader top({&document, ""}, unknownKeys);
    describe(top, material);
    return material;
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
