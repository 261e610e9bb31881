#include "gpu/program_binaries.h"

#include <glad/gl.h>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <system_error>

#include "gpu/context.h"
#include "gpu/data_path.h"

namespace kerf::gpu {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMagic = 0x314e49424652454bU;  // "KERFBIN1"
constexpr std::uint64_t kFirstSeed = 0xcbf29ce484222325U;
constexpr std::uint64_t kSecondSeed = 0x84222325cbf29ce4U;

/// What stands before the binary in a file.
struct FileHead {
    std::uint64_t magic = kMagic;
    std::uint64_t hash = 0;  ///< of the binary
    std::uint32_t format = 0;
    std::uint32_t size = 0;  ///< of the binary [bytes]
};

/// FNV-1a.
template <class Bytes>
std::uint64_t hashOf(const Bytes& bytes, std::uint64_t seed) {
    std::uint64_t hash = seed;
    for (const auto byte : bytes) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    }
    return hash;
}

std::vector<char> bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Nobody ever sees half of a file, and a second start may write the same one.
void writeWhole(const fs::path& file, const FileHead& head, const std::vector<char>& binary) {
    fs::path unfinished = file;
    unfinished += "." + std::to_string(getpid());
    std::ofstream out(unfinished, std::ios::binary);
    out.write(reinterpret_cast<const char*>(&head), sizeof head);
    out.write(binary.data(), static_cast<std::streamsize>(binary.size()));
    out.close();
    std::error_code error;
    if (out) {
        fs::rename(unfinished, file, error);
    }
    if (!out || error) {
        fs::remove(unfinished, error);
    }
}

/// A driver that refuses what an older one wrote says so in an error, which is none of ours.
bool takes(GLuint program, const FileHead& head, const char* binary) {
    glProgramBinary(program, head.format, binary, static_cast<GLsizei>(head.size));
    while (glGetError() != GL_NO_ERROR) {
    }
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    return linked != 0;
}

}  // namespace

ProgramBinaries::ProgramBinaries(fs::path folder, const std::string& version) {
    GLint formats = 0;
    glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    std::error_code error;
    if (formats == 0 || folder.empty() ||
        (!fs::create_directories(folder, error) && !fs::is_directory(folder, error))) {
        return;
    }
    const DeviceInfo device = queryDevice();
    maker_ = version + "\n" + device.vendor + "\n" + device.renderer + "\n" + device.version + "\n";
    folder_ = std::move(folder);
}

ProgramBinaries& ProgramBinaries::ours() {
    static ProgramBinaries binaries;
    return binaries;
}

fs::path ProgramBinaries::fileOf(const std::string& sources) const {
    const std::string all = maker_ + sources;
    return folder_ /
           fmt::format("{:016x}{:016x}", hashOf(all, kFirstSeed), hashOf(all, kSecondSeed));
}

bool ProgramBinaries::load(std::uint32_t program, const std::string& sources) const {
    const std::vector<char> bytes =
        folder_.empty() ? std::vector<char>() : bytesOf(fileOf(sources));
    if (bytes.size() <= sizeof(FileHead)) {
        return false;
    }
    FileHead head;
    std::memcpy(&head, bytes.data(), sizeof head);
    const std::vector<char> binary(bytes.begin() + sizeof head, bytes.end());
    return head.magic == kMagic && head.size == binary.size() &&
           head.hash == hashOf(binary, kFirstSeed) && takes(program, head, binary.data());
}

void ProgramBinaries::save(std::uint32_t program, const std::string& sources) const {
    GLint size = 0;
    if (!folder_.empty()) {
        glGetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &size);
    }
    if (size <= 0) {
        return;
    }
    std::vector<char> binary(static_cast<std::size_t>(size));
    FileHead head;
    glGetProgramBinary(program, size, &size, &head.format, binary.data());
    binary.resize(static_cast<std::size_t>(size));
    head.size = static_cast<std::uint32_t>(size);
    head.hash = hashOf(binary, kFirstSeed);
    writeWhole(fileOf(sources), head, binary);
}

fs::path programBinariesFolder() {
    return userPath("XDG_CACHE_HOME", ".cache", "programs");
}

}  // namespace kerf::gpu
