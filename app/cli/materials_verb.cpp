#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/option_checks.h"
#include "app/cli/verb.h"
#include "app/files/io/errors.h"
#include "app/session/material.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

/// The arguments of `kerf materials [NAME|FILE] [--json]`, parsed.
struct MaterialsArguments {
    std::string material;  ///< a builtin name or a file; empty for the list
    bool json = false;
};

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size(), width), ' ');
    return text;
}

void printList(std::ostream& out) {
    constexpr std::size_t kNameWidth = 15;
    constexpr std::size_t kValueWidth = 13;
    for (const std::string& name : materialNames()) {
        const Material material = findMaterial(name, {});
        std::string line = padded(name, kNameWidth);
        line.append(padded(valueText(material, materialProperties()[0]), kValueWidth));
        line.append(padded(valueText(material, materialProperties()[1]), kValueWidth));
        out << line.append(material.about) << "\n";
    }
}

void printOne(const Material& material, std::ostream& out) {
    out << printable(material.label) << (material.about.empty() ? "" : ": ")
        << printable(material.about) << "\n";
    for (const MaterialProperty& property : materialProperties()) {
        const std::string line = describeProperty(material, property);
        if (line.empty()) {
            continue;
        }
        out << line << "\n";
        for (const std::string& source : describeSources(material, property)) {
            out << "    " << source << "\n";
        }
    }
}

/// As it stands in a file, with its name.
Json toJson(const Material& material) {
    Json json{{"name", material.name}};
    json.update(Json::parse(formatMaterial(material)));
    return json;
}

Json listAsJson() {
    Json list = Json::array();
    for (const std::string& name : materialNames()) {
        list.push_back(toJson(findMaterial(name, {})));
    }
    return {{"materials", list}};
}

int runMaterials(const MaterialsArguments& arguments, std::ostream& out) {
    const bool one = !arguments.material.empty();
    if (arguments.json) {
        out << (one ? toJson(findMaterial(arguments.material, {})) : listAsJson()).dump() << "\n";
    } else if (one) {
        printOne(findMaterial(arguments.material, {}), out);
    } else {
        printList(out);
    }
    return kExitDone;
}

std::function<int()> describeMaterials(CLI::App& verb) {
    const auto arguments = std::make_shared<MaterialsArguments>();
    verb.add_option("MATERIAL", arguments->material,
                    "A name of the list, or a material file (.json)")
        ->check(refuseEmpty);
    verb.add_flag("--json", arguments->json, "Print one JSON object");
    return [arguments] { return runMaterials(*arguments, std::cout); };
}

}  // namespace

const Verb kMaterialsVerb{"materials",
                          "List the materials that come with Kerf, or show one with its sources",
                          describeMaterials};

}  // namespace kerf::app
