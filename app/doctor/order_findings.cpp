// Whether a driver keeps the order of what is written into a buffer and read of it, and compiles
// forms of kernels that others got wrong.
#include <glad/gl.h>
#include <spdlog/fmt/fmt.h>

#include <cctype>
#include <deque>

#include "app/doctor/findings.h"
#include "gpu/program.h"
#include "gpu/read_back.h"
#include "gpu/traffic.h"
#include "sim/base/containers.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

using Word = std::uint32_t;
using Words = std::vector<Word>;

constexpr std::size_t kWordBytes = sizeof(Word);
constexpr std::size_t kLarge = std::size_t{1} << 24;  // [bytes]; from there on fewer cells

enum Value : Word { kZero, kFirst, kSecond, kBefore };  // small: some become numbers of groups

gpu::Program kernel(const gpu::Defines& defines) {
    return gpu::Program::compute("doctor/words.comp", defines);
}

/// What writers and readers of buffers of one size work with.
struct Bench {
    explicit Bench(std::size_t bytes) : count(bytes / kWordBytes) {
        for (const Word value : {kZero, kFirst, kSecond, kBefore}) {
            words[value].assign(count, value);
            sources[value].assign(words[value]);
        }
    }

    std::size_t count;
    std::array<Words, 4> words;          ///< by value
    std::array<gpu::Buffer, 4> sources;  ///< of copies, by value
    gpu::Buffer shown;                   ///< by kernels that read
    gpu::ReadBack mapped;
    std::function<void()> writeNext;  ///< over what was read, before it is looked at
    gpu::Program write = kernel({});
    gpu::Program ofStorage = kernel({{"OF_STORAGE", "1"}});
    gpu::Program ofTexels = kernel({{"OF_TEXELS", "1"}});
    gpu::Program ofUniform = kernel({{"OF_UNIFORM", "1"}});
    gpu::Program ofIndirect = kernel({{"OF_INDIRECT", "1"}});
};

/// Words of a buffer.
struct Part {
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t end() const { return first + count; }
    GLintptr offset() const { return static_cast<GLintptr>(first * kWordBytes); }
    GLsizeiptr bytes() const { return static_cast<GLsizeiptr>(count * kWordBytes); }
};

// --- Writers ------------------------------------------------------------------------------------

void writeByKernel(Bench& bench, gpu::Buffer& buffer, const Part& part, Word value) {
    const auto count = static_cast<Word>(part.count);
    buffer.bindStorage(0);
    bench.write.setNumbers({static_cast<Word>(part.first), count, value, 0});
    bench.write.dispatch(count);
}

void writeBySubData(Bench& bench, gpu::Buffer& buffer, const Part& part, Word value) {
    buffer.write(part.first, std::span<const Word>(bench.words[value]).first(part.count));
}

void copy(const gpu::Buffer& from, const gpu::Buffer& to, const Part& part) {
    gpu::updateBarrier();
    glCopyNamedBufferSubData(from.id(), to.id(), part.offset(), part.offset(), part.bytes());
}

void writeByCopy(Bench& bench, gpu::Buffer& buffer, const Part& part, Word value) {
    copy(bench.sources[value], buffer, part);
}

template <GLenum kFormat, GLenum kType>
void clear(Bench& /*bench*/, gpu::Buffer& buffer, const Part& part, Word value) {
    gpu::updateBarrier();
    glClearNamedBufferSubData(buffer.id(), kFormat, part.offset(), part.bytes(), GL_RED_INTEGER,
                              kType, &value);
}

/// As a buffer grows: the rest is copied from the one before.
void writeByNewStorage(Bench& bench, gpu::Buffer& buffer, const Part& part, Word value) {
    gpu::Buffer grown;
    grown.assign(bench.words[value]);
    for (const Part& rest : {Part{0, part.first}, Part{part.end(), bench.count - part.end()}}) {
        if (rest.count > 0) {
            copy(buffer, grown, rest);
        }
    }
    buffer = std::move(grown);
}

struct Writer {
    const char* name;
    void (*write)(Bench&, gpu::Buffer&, const Part&, Word);
    bool zeros = false;  ///< whatever it should write
    Word valueOf(Word value) const { return zeros ? Word{kZero} : value; }
};

constexpr Writer kWriters[] = {
    {"a write by a kernel", writeByKernel},
    {"a write by glNamedBufferSubData()", writeBySubData},
    {"a copy by glCopyNamedBufferSubData()", writeByCopy},
    {"a clear by glClearNamedBufferSubData(GL_R8UI)", clear<GL_R8UI, GL_UNSIGNED_BYTE>, true},
    {"a clear by glClearNamedBufferSubData(GL_R32UI)", clear<GL_R32UI, GL_UNSIGNED_INT>},
    {"new storage", writeByNewStorage},
};

// --- Readers ------------------------------------------------------------------------------------

/// What a kernel shows of so many words, which are `before` until it does.
template <class Dispatch>
Words shown(Bench& bench, std::size_t count, Word before, Dispatch dispatch) {
    bench.shown.assign(Words(count, before));
    bench.shown.bindStorage(0);
    dispatch();
    bench.writeNext();
    return bench.shown.read<Word>(0, count);
}

Words shownBy(const gpu::Program& program, Bench& bench, const Part& part) {
    return shown(bench, part.count, kBefore, [&] {
        program.setNumbers({0, static_cast<Word>(part.count), 0, 0});
        program.dispatch(static_cast<Word>(part.count));
    });
}

Words readStorage(Bench& bench, const gpu::Buffer& buffer, const Part& part) {
    buffer.bindStorage(1);
    return shownBy(bench.ofStorage, bench, part);
}

Words readTexels(Bench& bench, const gpu::Buffer& buffer, const Part& part) {
    buffer.bindTexels(0, gpu::TexelFormat::uint32);
    return shownBy(bench.ofTexels, bench, part);
}

/// The words are the numbers of a dispatch.
Words readUniform(Bench& bench, const gpu::Buffer& buffer, const Part& part) {
    constexpr std::size_t kNumbers = 4;
    const auto bind = [](const gpu::Buffer& numbers, GLintptr offset) {
        glBindBufferRange(GL_UNIFORM_BUFFER, 0, numbers.id(), offset, kNumbers * kWordBytes);
    };
    gpu::barrier(GL_UNIFORM_BARRIER_BIT);
    bind(buffer, part.offset());
    Words words = shown(bench, kNumbers, kBefore, [&] { bench.ofUniform.dispatchGroups(1); });
    // Zink of Mesa 22.3 crashes in the kernel after one whose uniform block was deleted.
    bind(bench.sources[kZero], 0);
    bench.ofUniform.dispatchGroups(1);
    return words;
}

/// The words are the numbers of groups.
Words readIndirect(Bench& bench, const gpu::Buffer& buffer, const Part& part) {
    return shown(bench, part.count, kZero,
                 [&] { bench.ofIndirect.dispatchIndirect(buffer, part.first * kWordBytes); });
}

Words readBack(Bench& /*bench*/, const gpu::Buffer& buffer, const Part& part) {
    return buffer.read<Word>(part.first, part.count);
}

Words readMapped(Bench& bench, const gpu::Buffer& buffer, const Part& part) {
    const std::size_t place = bench.mapped.ask(buffer, part.count * kWordBytes);
    bench.mapped.send();
    bench.writeNext();
    const std::span<const Word> words = bench.mapped.read<Word>(place, part.count);
    return {words.begin(), words.end()};
}

struct Reader {
    const char* name;
    Words (*read)(Bench&, const gpu::Buffer&, const Part&);
    std::size_t most = SIZE_MAX;  ///< words; of larger buffers it reads the beginning of the middle
    std::size_t least = 1;        ///< words of a buffer
};

constexpr Reader kReaders[] = {
    {"a kernel", readStorage},
    {"texels", readTexels},
    {"a uniform block", readUniform, 4},
    {"an indirect dispatch", readIndirect, 3, 3},
    {"glGetNamedBufferSubData()", readBack},
    {"mapped memory", readMapped},
};

// --- The matrix ---------------------------------------------------------------------------------

/// Whether what a reader sees is right: one writer writes all, another the middle, and where the
/// reader runs on the GPU, the first one all again before the CPU looks.
bool isRight(Bench& bench, const Writer& first, const Writer& second, const Reader& reader) {
    const Part all{0, bench.count};
    const Part middle{bench.count / 4, (bench.count + 1) / 2};
    gpu::Buffer buffer;
    buffer.assign(bench.words[kBefore]);
    first.write(bench, buffer, all, first.valueOf(kFirst));
    second.write(bench, buffer, middle, second.valueOf(kSecond));
    const Part seen = reader.most < bench.count ? Part{middle.first, reader.most} : all;
    bench.writeNext = [&] { first.write(bench, buffer, all, first.valueOf(kBefore)); };
    const Words words = reader.read(bench, buffer, seen);
    for (std::size_t i = seen.first; i < seen.end(); ++i) {
        const bool inMiddle = i >= middle.first && i < middle.end();
        if (words[i - seen.first] != (inMiddle ? second.valueOf(kSecond) : first.valueOf(kFirst))) {
            return false;
        }
    }
    return true;
}

/// Of the largest buffers only each writer after each, and each reader after each writer.
bool isTried(const Bench& bench, const Writer& first, const Writer& second, const Reader& reader) {
    const auto turn = (&first - kWriters) + (&second - kWriters) + (&reader - kReaders);
    return bench.count >= reader.least &&
           (bench.count * kWordBytes < kLarge || turn % std::ssize(kReaders) == 0);
}

std::string sizeText(std::size_t bytes) {
    return bytes >= 1U << 20   ? fmt::format("{} MB", bytes >> 20)
           : bytes >= 1U << 10 ? fmt::format("{} KB", bytes >> 10)
                               : fmt::format("{} bytes", bytes);
}

/// How two writers came out.
struct PairResult {
    int tried = 0;
    int right = 0;
    std::set<std::size_t> sizes;  ///< of buffers in which the second was lost [bytes]
    std::set<std::string> readers;
};

PairResult tryPair(std::deque<Bench>& benches, const Writer& first, const Writer& second) {
    PairResult result;
    for (Bench& bench : benches) {
        for (const Reader& reader : kReaders) {
            if (isTried(bench, first, second, reader)) {
                ++result.tried;
                if (isRight(bench, first, second, reader)) {
                    ++result.right;
                } else {
                    result.sizes.insert(bench.count * kWordBytes);
                    result.readers.insert(reader.name);
                }
            }
        }
    }
    return result;
}

/// "A copy after a write by a kernel: lost in buffers of 4 bytes, as seen by texels".
DriverFinding findingOf(const Writer& first, const Writer& second, const PairResult& result) {
    std::string check = fmt::format("{} after {}", second.name, first.name);
    check.front() = static_cast<char>(std::toupper(check.front()));
    return {std::move(check),
            fmt::format("lost in buffers of {}, as seen by {}",
                        enumerated(mapped(result.sizes, sizeText)), enumerated(result.readers)),
            "what was written last", false};
}

// --- Forms --------------------------------------------------------------------------------------

constexpr std::size_t kFormThreads = 128;

struct Form {
    const char* name;
    Word answer;  ///< of each thread
};

/// In the order of shaders/doctor/forms.comp.
constexpr Form kForms[] = {
    {"A count by one thread at a time, with barriers in a loop", 128},
    {"Barriers in a branch that all threads take", 128},
};

/// Of more groups than OpenGL promises, where the driver takes them.
DriverFinding groupsFinding() {
    constexpr Word kMost = 70'000;
    GLint limit = 0;
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &limit);
    const Word groups = std::min(kMost, static_cast<Word>(limit));
    gpu::Buffer last;
    last.assign(Words(3, kZero));
    last.bindStorage(0);
    kernel({{"OF_INDIRECT", "1"}}).dispatchGroups(groups);
    const Word seen = last.read<Word>(0, 1).front();
    return {"Work groups at once", std::to_string(seen), std::to_string(groups), seen == groups};
}

}  // namespace

std::vector<DriverFinding> orderFindings(const std::vector<std::size_t>& sizes) {
    const gpu::ProgramShelf shelf;  // for the benches together
    std::deque<Bench> benches(sizes.begin(), sizes.end());
    std::vector<DriverFinding> findings(1);
    int tried = 0;
    int right = 0;
    for (const Writer& first : kWriters) {
        for (const Writer& second : kWriters) {
            const PairResult result = tryPair(benches, first, second);
            tried += result.tried;
            right += result.right;
            if (result.right < result.tried) {
                findings.push_back(findingOf(first, second, result));
            }
        }
    }
    findings.front() = {"Order of writes and reads", fmt::format("{} of {}", right, tried), "all",
                        right == tried};
    return findings;
}

std::vector<DriverFinding> formFindings() {
    const gpu::Program forms = gpu::Program::compute("doctor/forms.comp");
    gpu::Buffer answers;
    answers.assign(Words(std::size(kForms) * kFormThreads, kZero));
    answers.bindStorage(0);
    forms.setNumbers({kFormThreads, 0, 0, 0});
    forms.dispatchGroups(1);
    std::vector<DriverFinding> findings;
    for (const Form& form : kForms) {
        const Words words = answers.read<Word>(findings.size() * kFormThreads, kFormThreads);
        const auto other = std::ranges::find_if(words, [&](Word w) { return w != form.answer; });
        const bool right = other == words.end();
        findings.push_back({form.name, std::to_string(right ? form.answer : *other),
                            std::to_string(form.answer), right});
    }
    findings.push_back(groupsFinding());
    return findings;
}

}  // namespace kerf::app
