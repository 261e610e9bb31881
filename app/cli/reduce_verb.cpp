#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>

#include "app/cli/option_checks.h"
#include "app/cli/verb.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "gpu/data_path.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

/// The arguments of `kerf reduce SESSION --out DIR -- COMMAND...`, parsed.
struct ReduceArguments {
    fs::path session;
    fs::path out;
    std::vector<std::string> command;
};

/// The folder of the Python package: of a build, of an installation, or around a wheel's program.
fs::path packageFolder() {
    const fs::path beside = gpu::programFolder();
    const fs::path above = beside.parent_path();
    for (const fs::path& folder :
         {beside / "python", above / "lib/python3/dist-packages", above / "../.."}) {
        if (fs::exists(folder / "kerf/reduce.py")) {
            return folder.lexically_normal();
        }
    }
    throw InputError(
        "The Python part of Kerf, which reduces sessions, is not there; build Kerf "
        "with -DKERF_PYTHON=ON, or install it again.");
}

constexpr const char* kStart =
    "import sys; sys.path[0] = sys.argv[1]; "
    "from kerf.reduce import main; sys.exit(main(sys.argv[2:]))";

/// Any Python does: the package needs its compiled module for other things only.
int becomeReduction(const ReduceArguments& arguments) {
    refuseFileAsFolder(arguments.out);
    std::vector<std::string> words{"python3",         "-B",         "-c", kStart, packageFolder(),
                                   arguments.session, arguments.out};
    words.insert(words.end(), arguments.command.begin(), arguments.command.end());
    std::vector<char*> pointers(words.size() + 1);  // the last one stays null
    std::ranges::transform(words, pointers.begin(), [](std::string& word) { return word.data(); });
    ::execvp(pointers[0], pointers.data());
    throw InputError(std::string("python3, which reduces sessions, can't be started (") +
                     std::strerror(errno) + "); install it.");
}

std::function<int()> describeReduce(CLI::App& verb) {
    const auto arguments = std::make_shared<ReduceArguments>();
    verb.add_option("SESSION", arguments->session, "A session for which the command fails")
        ->required()
        ->check(refuseEmpty);
    verb.add_option("COMMAND", arguments->command,
                    "After --: a program with its arguments. {} stands for the path of a session, "
                    "else that comes last. Exit code 0 means that it does not fail; another one "
                    "than for SESSION does not count either")
        ->required();
    addOut(verb, arguments->out,
           "Folder for reduced.kerf.json; the same call resumes what was stopped")
        ->required();
    return [arguments] { return becomeReduction(*arguments); };
}

}  // namespace

const Verb kReduceVerb{"reduce", "Make a session small for which a command fails; needs python3",
                       describeReduce};

}  // namespace kerf::app
