#include "app/cli/import_worker_verb.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "app/files/import/import_process.h"

namespace kerf::app {

namespace {

std::function<int()> describeImportWorker(CLI::App& verb) {
    const auto file = std::make_shared<std::filesystem::path>();
    verb.group("");  // hides it
    verb.add_option("FILE", *file)->required();
    return [file] { return runImportWorker(*file); };
}

}  // namespace

const Verb kImportWorkerVerb{"import-worker", "", describeImportWorker};

}  // namespace kerf::app
