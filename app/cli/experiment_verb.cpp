#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "app/cli/program.h"
#include "app/cli/verb.h"
#include "app/files/io/errors.h"
#include "app/files/jobs/child_process.h"

namespace kerf::app {

namespace {

/// The laboratory takes the place of this program, with the words behind the verb.
int becomeLaboratory(char** words) {
    std::string program = programBeside("kerf-lab");
    words[0] = program.data();
    ::execv(program.c_str(), words);
    return complain(program + ", which runs experiments, can't be started (" +
                        std::strerror(errno) +
                        "); it is no part of an installed Kerf: scripts/build of the source tree "
                        "makes it.",
                    kExitInput);
}

}  // namespace

const Verb kExperimentVerb{"experiment",
                           "Run the paper's experiments, the virtual test bench, or a "
                           "comparison with finite elements, headless, and write a report; "
                           "needs kerf-lab, which is built from the source tree, not installed",
                           nullptr, becomeLaboratory};

}  // namespace kerf::app
