#pragma once

#include <filesystem>
#include <iosfwd>

namespace kerf::app {

/// The arguments of `kerf doctor [--quick] [--out DIR] [--json]`, parsed.
struct DoctorArguments {
    bool quick = false;         ///< leaves the speeds out
    std::filesystem::path out;  ///< folder of the report; empty for none
    bool json = false;
};

/// Examines the graphics driver of this machine and prints on `out` what is right and what not. The
/// report, report.md with doctor.json and cut.png, goes into `arguments.out`. Progress goes to
/// `errors`. Returns the exit code: 0, or 1 where something is not as it should be. Throws
/// gpu::ContextError, InputError, OutputError.
int doctorVerb(const DoctorArguments& arguments, std::ostream& out, std::ostream& errors);

}  // namespace kerf::app
