#pragma once

#include <functional>

namespace CLI {  // NOLINT(readability-identifier-naming): a name of its authors
class App;
}

namespace kerf::app {

/// A verb of the command line, as its own file declares it. `kerf --help` lists all by name.
struct Verb {
    const char* name;
    const char* about;  ///< what it is for, in a sentence of `kerf --help`; empty for a hidden verb
    /// Describes its options to `parser`, and returns what runs it with the values that they were
    /// given. That prints results on standard output, and returns the exit code or throws one of
    /// the errors that runSafely() knows. Null with `takeOver`.
    std::function<int()> (*describe)(CLI::App& parser);
    /// Null, or what runs the verb instead of all this, before a word is parsed. `words` are those
    /// of the command line from the verb on; the last one is followed by null.
    int (*takeOver)(char** words) = nullptr;
};

}  // namespace kerf::app
