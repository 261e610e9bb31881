#include <CLI/CLI.hpp>
#include <iostream>

#include "app/cli/verb.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "gpu/data_path.h"

namespace kerf::app {

namespace {

constexpr std::uintmax_t kMostBytes = 1u << 20;

std::function<int()> describeSchema(CLI::App& verb) {
    const auto kind = std::make_shared<std::string>("session");
    verb.add_option("KIND", *kind, "session (default) or material")
        ->check(CLI::IsMember({"session", "material"}));
    return [kind] {
        std::cout << readInputFile(gpu::dataPath("docs/" + *kind + ".schema.json"), kMostBytes);
        return kExitDone;
    };
}

}  // namespace

const Verb kSchemaVerb{
    "schema",
    "Print the JSON Schema of sessions or materials, for checks and completion in text editors",
    describeSchema};

}  // namespace kerf::app
