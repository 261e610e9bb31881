#include "tests/support/session_schema.h"

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/files/import/builtin_models.h"
#include "app/session/session_table.h"
#include "sim/base/text.h"
#include "tests/paths.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

/// Whole numbers without a decimal point.
Json number(double value) {
    return std::floor(value) == value ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json vectorOf(const Vec3& v) {
    return {number(v.x()), number(v.y()), number(v.z())};
}

Json numberSchema(double low, double high) {
    return {{"type", "number"}, {"minimum", number(low)}, {"maximum", number(high)}};
}

/// Not of the type "integer", which for some editors 20.0 is not.
Json wholeNumberSchema(double low, double high) {
    Json schema = numberSchema(low, high);
    schema["multipleOf"] = 1;
    return schema;
}

Json vectorSchema(double low, double high) {
    return {
        {"type", "array"}, {"items", numberSchema(low, high)}, {"minItems", 3}, {"maxItems", 3}};
}

/// `problem` is what editors show instead of the pattern.
Json patternSchema(const std::string& pattern, const std::string& problem) {
    return {{"type", "string"}, {"pattern", pattern}, {"patternErrorMessage", problem}};
}

// What a value must be like, by its type and its rule.

Json schemaOf(bool) {
    return {{"type", "boolean"}};
}

Json schemaOf(double, const Limits& limits) {
    return numberSchema(limits.low, limits.high);
}

Json schemaOf(int, const Limits& limits) {
    return wholeNumberSchema(limits.low, limits.high);
}

Json schemaOf(const Vec3&, const Limits& limits) {
    return vectorSchema(limits.low, limits.high);
}

Json schemaOf(const std::string&, const HexDigits& digits) {
    const std::string count = std::to_string(digits.count);
    return patternSchema("^[0-9a-f]{" + count + "}$",
                         "Expected " + count + " lower-case hexadecimal digits.");
}

Json schemaOf(const std::string&, const BuiltinName&) {
    return {{"enum", builtinModels()}};
}

Json schemaOf(const std::filesystem::path&, const ModelPath&) {
    return {{"type", "string"}, {"pattern", "^[^\\u0000]*$"}};
}

/// A pattern of this text alone; letters may be capitals where that is wanted.
std::string literalPattern(std::string_view text, bool anyCase) {
    std::string pattern;
    for (const char c : text) {
        if (c == '.') {
            pattern += "\\.";
        } else if (anyCase && c >= 'a' && c <= 'z') {
            pattern.append("[").append(1, c).append(1, static_cast<char>(c - 'a' + 'A')) += "]";
        } else {
            pattern += c;
        }
    }
    return pattern;
}

/// Names that lead out of the output folder on a detour ("a/../../b.png") pass.
Json schemaOf(const std::string&, const OutputName& rule) {
    const auto exactly = [](std::string_view text) { return literalPattern(text, false); };
    const auto inAnyCase = [](std::string_view text) { return literalPattern(text, true); };
    return patternSchema("^(?!/)(?!(\\./+)*\\.\\./)(?!(\\./+)*(" +
                             joined(kReplayFiles, "|", exactly) + ")(/|$))[^\\u0000]*[^/\\u0000](" +
                             joined(rule.endings, "|", inAnyCase) + ")$",
                         "Expected a file inside the output folder (" + joined(rule.endings, ", ") +
                             ") that no replay writes itself.");
}

/// Of characters, of which a text has no more than bytes.
Json schemaOf(const std::string&, const ShortText& rule) {
    return {{"type", "string"}, {"maxLength", rule.most}};
}

Json schemaOf(const std::vector<std::string>&, const Words& rule) {
    return {{"type", "array"}, {"items", {{"enum", rule.words}}}};
}

template <class Item>
Json schemaOf(const std::vector<Item>&, const Limits& limits) {
    return {{"type", "array"}, {"items", schemaOf(Item{}, limits)}};
}

template <class Enum>
requires std::is_enum_v<Enum> Json schemaOf(Enum, const Words& rule) {
    return {{"enum", rule.words}};
}

template <class Value>
Json schemaOf(const std::optional<Value>&, const auto& rule) {
    return schemaOf(Value{}, rule);
}

// What a field that is left out counts as; null for nothing.

Json defaultOf(const auto&) {
    return nullptr;
}
Json defaultOf(bool flag) {
    return flag;
}
Json defaultOf(int value) {
    return value;
}
Json defaultOf(double value) {
    return number(value);
}
Json defaultOf(const Vec3& value) {
    return vectorOf(value);
}

Json plainParamSchema(const ParamInfo& info) {
    switch (info.type) {
        case ParamType::real:
            return numberSchema(info.low, info.high);
        case ParamType::integer:
            return info.choices.empty()
                       ? wholeNumberSchema(info.low, info.high)
                       : Json{{"anyOf", Json::array({wholeNumberSchema(info.low, info.high),
                                                     Json{{"enum", info.choices}}})}};
        case ParamType::vector:
            return vectorSchema(info.low, info.high);
        case ParamType::optionalReal: {
            Json schema = numberSchema(info.low, info.high);
            schema["type"] = {"number", "null"};
            return schema;
        }
        case ParamType::choice:
            return {{"enum", info.choices}};
    }
    return {};
}

Json defaultOf(const ParamInfo& info) {
    const ParamValue value = getParam(Params{}, info.name);
    if (const auto* real = std::get_if<double>(&value)) return number(*real);
    if (const auto* vector = std::get_if<Vec3>(&value)) return vectorOf(*vector);
    if (const auto* choice = std::get_if<std::string>(&value)) return *choice;
    return nullptr;
}

/// " From 10 to 20000 kg/m^3; 1000 where left out."
std::string rangeSentence(const ParamInfo& info) {
    std::string range;
    if (info.type != ParamType::choice) {
        const std::string unit = info.unit.empty() ? "" : " " + std::string(info.unit);
        range = " From " + number(info.low).dump() + " to " + number(info.high).dump() + unit;
        range += info.type == ParamType::optionalReal ? ", or null" : "";
        range += info.choices.empty() ? ";" : ", or \"" + std::string(info.choices[0]) + "\";";
    }
    return range + " " + defaultOf(info).dump() + " where left out.";
}

Json paramSchema(const ParamInfo& info) {
    Json schema{{"description", std::string(info.meaning) + rangeSentence(info)}};
    schema.update(plainParamSchema(info));
    schema["default"] = defaultOf(info);
    return schema;
}

/// "^(density|...)@[1-9][0-9]?$"
std::string patternOfOwnNames() {
    std::string names;
    for (const ParamInfo& info : paramTable()) {
        if (info.perModel) {
            names.append(names.empty() ? "" : "|").append(info.name);
        }
    }
    return "^(" + names + ")@[1-9][0-9]?$";
}

/// Parameters have no unknown names.
Json paramsSchema() {
    Json schema{{"type", "object"}};
    for (const ParamInfo& info : paramTable()) {
        schema["properties"][std::string(info.name)] = paramSchema(info);
    }
    schema["patternProperties"][patternOfOwnNames()] = {
        {"description", "That of one of the further models, by its number. Null: as all models."},
        {"type", {"number", "null"}}};
    schema["additionalProperties"] = false;
    return schema;
}

/// One of several words, each with its meaning.
Json choiceOf(const std::vector<std::pair<std::string, std::string>>& wordsAndMeanings) {
    Json schema;
    for (const auto& [word, meaning] : wordsAndMeanings) {
        schema["enum"].push_back(word);
        schema["enumDescriptions"].push_back(meaning);
    }
    return schema;
}

/// `then` where a key has one of these values. Other than one of several alternatives, it lets an
/// editor name what is wrong with this one.
Json whereKeyIs(const char* key, const std::vector<std::string>& values, Json then) {
    return {{"if", {{"properties", {{key, {{"enum", values}}}}}, {"required", {key}}}},
            {"then", std::move(then)}};
}

template <class Item, class... Rule>
Json objectSchema(Item item, const Rule&... rule);

/// Collects the fields of an object as describe() names them, as the keywords of its schema.
class FieldSchemas : public NoFields {
  public:
    Json keywords() const { return keywords_; }
    const std::vector<Word>& types() const { return types_; }

    void type(const Word& word) { types_.push_back(word); }
    void type(const Word& word, const Word& otherwise, bool) { types_ = {word, otherwise}; }

    void required(const Word& word, const auto& value, const auto&... rule) {
        property(word, valueSchema(value, rule...));
        keywords_["required"].push_back(word.name);
    }

    void optional(const Word& word, const auto& value, const auto&... rule) {
        Json schema = valueSchema(value, rule...);
        if (const Json otherwise = defaultOf(value); !otherwise.is_null()) {
            schema["default"] = otherwise;
        }
        property(word, schema);
    }

    void exactlyOneOf(Keys keys, std::string_view) { needKeys("oneOf", keys); }
    void atLeastOneOf(Keys keys, std::string_view) { needKeys("anyOf", keys); }

    /// The keys of a ball are there together or not at all, as are those of a box.
    void oneOf(const Region&, std::string_view) {
        for (const Json& shape : {objectSchema(Ball{}), objectSchema(Bounds{})}) {
            keywords_["properties"].update(shape["properties"]);
            for (const Json& key : shape["required"]) {
                keywords_["dependencies"][key.get<std::string>()] = shape["required"];
            }
            keywords_["oneOf"].push_back({{"required", {shape["required"][0]}}});
        }
    }

    void param(const Word& nameWord, const std::string&, const Word& valueWord, const ParamValue&) {
        std::vector<std::pair<std::string, std::string>> names;
        for (const ParamInfo& info : paramTable()) {
            const std::string name(info.name);
            names.emplace_back(name, info.meaning);
            const Json value{{"$ref", "#/properties/params/properties/" + name}};
            keywords_["allOf"].push_back(
                whereKeyIs(nameWord.name, {name}, {{"properties", {{valueWord.name, value}}}}));
        }
        const Json own{{"type", "string"}, {"pattern", patternOfOwnNames()}};
        property(nameWord, {{"anyOf", Json::array({choiceOf(names), own})}});
        property(valueWord, Json::object());
        keywords_["required"] = {nameWord.name, valueWord.name};
    }

    void ignored(const Word& word) { property(word, Json::object()); }

    void format(const Word& formatWord, const Word& versionWord, const FileFormat& format) {
        property(formatWord, {{"const", format.name}});
        Json version = numberSchema(format.version, format.version);
        version.erase("maximum");
        version["exclusiveMaximum"] = format.version + 1;
        version["default"] = format.version;
        property(versionWord, version);
        keywords_["required"] = {formatWord.name, versionWord.name};
    }

    void material(const Word& word, const Session&) {
        std::vector<std::pair<std::string, std::string>> names;
        for (const std::string& name : materialNames()) {
            names.emplace_back(name, findMaterial(name, {}).about);
        }
        const Json file{{"type", "string"}, {"pattern", "^[^\\u0000]*\\.[jJ][sS][oO][nN]$"}};
        property(word, {{"anyOf", Json::array({choiceOf(names), file})}});
    }

    void params(const Word& word, const Session&) { property(word, paramsSchema()); }

    template <class Item>
    void list(const Word& word, const std::vector<Item>&, std::size_t most) {
        property(word, {{"type", "array"}, {"items", objectSchema(Item{})}, {"maxItems", most}});
    }

    void events(const Word& word, const std::vector<SessionEvent>&, const Limits& steps) {
        property(word, {{"type", "array"}, {"items", objectSchema(SessionEvent{}, steps)}});
    }

    void action(const Word& word, const SessionAction&) {
        std::vector<std::pair<std::string, std::string>> types;
        forEachKind(std::type_identity<SessionAction>{}, [&](auto event) {
            FieldSchemas fields;
            describe(fields, event);
            std::vector<std::string> names;
            for (const Word& type : fields.types()) {
                names.emplace_back(type.name);
                types.emplace_back(type.name, type.meaning);
            }
            keywords_["allOf"].push_back(whereKeyIs(word.name, names, fields.keywords()));
        });
        property(word, choiceOf(types));
        keywords_["required"].push_back(word.name);
    }

  private:
    void property(const Word& word, const Json& schema) {
        Json& property = keywords_["properties"][word.name];
        property["description"] = word.meaning;
        property.update(schema);
    }

    void needKeys(const char* howMany, Keys keys) {
        for (const char* key : keys) {
            keywords_[howMany].push_back({{"required", {key}}});
        }
    }

    /// Of a value, or of an object that describe() knows.
    template <class Value, class... Rule>
    static Json valueSchema(const Value& value, const Rule&... rule) {
        if constexpr (requires(FieldSchemas fields, Value item) {
                          describe(fields, item, rule...);
                      }) {
            return objectSchema(value, rule...);
        } else if constexpr (requires(FieldSchemas fields, Value item) {
                                 describe(fields, *item, rule...);
                             }) {
            return objectSchema(typename Value::value_type{}, rule...);
        } else {
            return schemaOf(value, rule...);
        }
    }

    std::vector<Word> types_;
    Json keywords_ = Json::object();
};

template <class Item, class... Rule>
Json objectSchema(Item item, const Rule&... rule) {
    FieldSchemas fields;
    describe(fields, item, rule...);
    Json schema{{"type", "object"}};
    schema.update(fields.keywords());
    return schema;
}

std::string schemaText(const std::string& kind, const FileFormat& format, const Json& object) {
    Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                {"title", kind + ", version " + std::to_string(format.version)}};
    schema.update(object);
    return schema.dump(2) + "\n";
}

}  // namespace

std::string sessionSchema() {
    Session blank;
    blank.steps = kMaxSteps;  // for the largest step of an event
    return schemaText("Kerf session", kSessionFormat, objectSchema(blank));
}

std::string materialSchema() {
    return schemaText("Kerf material", kMaterialFormat, objectSchema(Material{}));
}

std::string schemaFile(const std::string& name, const std::string& text) {
    const std::string file = KERF_SOURCE_DIR "/docs/" + name;
    if (std::getenv("KERF_RENEW") != nullptr) {
        test::writeText(file, text);
    }
    return test::readBytes(file);
}

}  // namespace kerf::app
