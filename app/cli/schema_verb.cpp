#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "app/cli/verb.h"
#include "app/files/io/exit_codes.h"
#include "app/session/material.h"
#include "app/session/session_schema.h"

namespace kerf::app {

namespace {

// Kinds of files that have a schema.
constexpr const char* kSessionKind = "session";
constexpr const char* kMaterialKind = "material";

std::function<int()> describeSchema(CLI::App& verb) {
    const auto kind = std::make_shared<std::string>(kSessionKind);
    verb.add_option("KIND", *kind, "session (where left out) or material")
        ->check(CLI::IsMember({kSessionKind, kMaterialKind}));
    return [kind] {
        std::cout << (*kind == kMaterialKind ? materialSchema() : sessionSchema());
        return kExitDone;
    };
}

}  // namespace

const Verb kSchemaVerb{
    "schema",
    "Print the JSON Schema of sessions or materials, by which text editors complete and check",
    describeSchema};

}  // namespace kerf::app
