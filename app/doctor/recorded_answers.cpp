#include "app/doctor/recorded_answers.h"

#include <cstddef>
#include <stdexcept>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "gpu/data_path.h"
#include "sim/base/byte_archive.h"

namespace kerf::app {

std::filesystem::path recordedAnswersFile() {
    return gpu::dataPath("assets/doctor/answers");
}

AnswersByModel recordedAnswers() {
    constexpr std::uintmax_t kMostBytes = 1 << 24;
    const std::string text = readInputFile(recordedAnswersFile(), kMostBytes);
    const auto* const first = reinterpret_cast<const std::byte*>(text.data());
    const std::vector<std::byte> bytes(first, first + text.size());
    AnswersByModel answers;
    try {
        ByteReader from(bytes);
        from(answers);
    } catch (const std::out_of_range&) {
        throw InputError(recordedAnswersFile().string() + " is damaged; install Kerf again.");
    }
    return answers;
}

}  // namespace kerf::app
