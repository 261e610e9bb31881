#include "app/doctor/doctor.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

#include "app/doctor/findings.h"
#include "gpu/buffer.h"
#include "gpu/program.h"
#include "sim/base/mapped.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {
namespace {

void append(std::vector<DriverFinding>& all, std::vector<DriverFinding> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

std::vector<DriverFinding> limitFindings(const std::vector<gpu::DriverLimit>& limits) {
    return mapped(limits, [](const gpu::DriverLimit& limit) -> DriverFinding {
        return {fmt::format("Limit: {}", limit.phrase), fmt::format("{}", limit.has),
                fmt::format("at least {}", limit.needs), limit.has >= limit.needs};
    });
}

/// Runs a part. What the driver can't do is a finding, and the other parts still run.
template <class Work>
void examine(const Examination& examination, Diagnosis& diagnosis, const std::string& part,
             Work work) {
    if (examination.next) {
        examination.next(part);
    }
    try {
        work();
    } catch (const gpu::ShaderError& error) {
        diagnosis.findings.push_back({part, error.what(), "shaders that compile", false});
    } catch (const gpu::OutOfMemory& error) {
        diagnosis.findings.push_back({part, error.what(), "memory for it", false});
    }
}

}  // namespace

bool Diagnosis::right() const {
    return debugErrors == 0 && std::ranges::all_of(findings, [](const DriverFinding& finding) {
               return finding.right;
           });
}

std::string Diagnosis::verdict() const {
    if (right()) {
        return "Kerf works as it should on this driver.";
    }
    return "Kerf does not work as it should on this driver. Update it; until then start Kerf with "
           "LIBGL_ALWAYS_SOFTWARE=1, which uses the software renderer. Please report it with what "
           "kerf doctor --out writes.";
}

Diagnosis diagnose(const Examination& examination) {
    const Stopwatch watch;
    Diagnosis diagnosis;
    diagnosis.device = gpu::queryDevice();
    diagnosis.limits = gpu::driverLimits();
    append(diagnosis.findings, limitFindings(diagnosis.limits));
    gpu::takeDebugErrors();
    examine(examination, diagnosis, "Orders", [&] {
        append(diagnosis.findings, orderFindings());
        append(diagnosis.findings, formFindings());
    });
    examine(examination, diagnosis, "Sessions",
            [&] { append(diagnosis.findings, sessionFindings()); });
    examine(examination, diagnosis, "A cut", [&] {
        CutFindings cut = cutFindings();
        append(diagnosis.findings, std::move(cut.findings));
        diagnosis.picture = std::move(cut.picture);
    });
    if (examination.speeds) {
        examine(examination, diagnosis, "Speed",
                [&] { diagnosis.speeds = modelSpeeds(examination.secondsEach); });
    }
    diagnosis.debugErrors = gpu::takeDebugErrors();
    diagnosis.seconds = watch.seconds();
    return diagnosis;
}

}  // namespace kerf::app
