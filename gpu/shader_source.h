#pragma once

#include "gpu/program.h"

namespace kerf::gpu {

/// A shader file with its includes expanded. #line directives tell explainLog() which of `files` a
/// line is from.
struct ShaderSource {
    std::string text;
    std::vector<std::string>
        files;  ///< as shown in messages, relative to the folder above shaders/
};

/// Reads `path` (below `root`, or absolute), writes out #include "x" and puts "#version 450 core"
/// and the defines in front. A file with #pragma once is written out once. Throws ShaderError
/// "file:line: ..." for a file that is missing or includes itself.
ShaderSource loadShaderSource(const std::filesystem::path& root, const std::string& path,
                              const Defines& defines);

/// A compiler's log for a ShaderSource with its places written as "file:line: message". Knows the
/// forms of Mesa "0:12(5): ...", NVIDIA "0(12) : ..." and AMD "ERROR: 0:12: ...".
std::string explainLog(std::string_view log, const std::vector<std::string>& files);

}  // namespace kerf::gpu
