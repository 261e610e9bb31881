#pragma once

#include "app/regression/run_trace.h"
#include "render/scene/image.h"

namespace kerf::app {

/// The result of one check of a driver.
struct DriverFinding {
    std::string check;  ///< "Free fall"
    std::string seen;   ///< the measured value, with its unit
    std::string asked;  ///< the value with a working driver
    bool right = false;
};

/// Every kind of writer after every other into a buffer, before every kind of reader: what is read
/// must be what was written last. One finding for all, and one for each two writers that are wrong.
/// `sizes`: of buffers [bytes]. Throws gpu::ShaderError, gpu::OutOfMemory.
std::vector<DriverFinding> orderFindings(const std::vector<std::size_t>& sizes = {
                                             4, 1 << 10, 1 << 16, 1 << 20, 1 << 24});

/// Forms of kernels that some drivers get wrong, and as many work groups as the driver takes.
/// Throws gpu::ShaderError, gpu::OutOfMemory.
std::vector<DriverFinding> formFindings();

/// A short session that ships with Kerf, in assets/doctor.
struct ShortSession {
    const char* name;   ///< of its files
    const char* check;  ///< DriverFinding::check
    double most;        ///< how far pieces may be off, as a share of the body's diagonal
};
std::span<const ShortSession> shortSessions();
/// The file with its pieces, as llvmpipe has them: a PieceTrace.
std::filesystem::path expectedPieces(const ShortSession& session);
/// Its pieces after every tenth step, on this driver. Throws like sessionFindings().
PieceTrace playShortSession(const ShortSession& session);

/// Short sessions in which bodies fall, bend, lie, rest on one another, on a box, and hang: their
/// pieces must be where they are on llvmpipe. `only`: the name of one; "" plays all. Throws
/// gpu::ShaderError, gpu::OutOfMemory, InputError if a file is missing.
std::vector<DriverFinding> sessionFindings(std::string_view only = "");

/// A body that is cut and falls, played twice: it must stay closed, end with the same bits, and
/// look as expected. `picture` shows the end.
struct CutFindings {
    std::vector<DriverFinding> findings;
    render::Image picture;
};
CutFindings cutFindings();

}  // namespace kerf::app
