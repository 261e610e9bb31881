#pragma once

#include <stdexcept>

namespace CLI {  // NOLINT(readability-identifier-naming): a name of its authors
class App;
}

namespace kerf::app {

/// A verb of the command line, declared in its own file. `kerf --help` lists all by name.
struct Verb {
    const char* name;
    const char* about;  ///< what it is for, in a sentence of `kerf --help`; empty for a hidden verb
    /// Describes its options to `parser`, and returns a function that runs it with their values.
    /// That prints results on standard output, and returns the exit code or throws an error known
    /// to runSafely(). Null with `takeOver`.
    std::function<int()> (*describe)(CLI::App& parser);
    /// Null, or a function that runs the verb instead, before parsing. `words` are the arguments
    /// from the verb on, followed by null.
    int (*takeOver)(char** words) = nullptr;
};

extern const Verb kCompareVerb;     ///< compares two pictures
extern const Verb kDoctorVerb;      ///< checks the graphics driver
extern const Verb kExperimentVerb;  ///< runs the separate program kerf-lab
extern const Verb kInspectVerb;     ///< describes a model, and whether it can be cut
extern const Verb kMaterialsVerb;   ///< the materials that come with Kerf
extern const Verb kReduceVerb;      ///< makes a failing session small
extern const Verb kReplayVerb;      ///< runs a session headless, with its results
extern const Verb kSchemaVerb;      ///< the JSON Schema of sessions or materials
extern const Verb kScoreVerb;       ///< a table of practised cuts
extern const Verb kSweepVerb;       ///< does the open runs of a study
extern const Verb kTestVerb;        ///< sessions as regression tests

/// A mistake on the command line: what() is one sentence that says what and what to do. Exit code
/// 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace kerf::app
