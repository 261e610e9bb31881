#include "app/doctor/doctor.h"

#include <ostream>

namespace kerf::app {
namespace {

/// A line about each finding that is wrong.
std::vector<std::string> wrongOnes(const std::vector<DriverFinding>& findings) {
    std::vector<std::string> wrong;
    for (const DriverFinding& finding : findings) {
        if (!finding.right) {
            wrong.push_back(finding.check + ": " + finding.seen + ", asked " + finding.asked);
        }
    }
    return wrong;
}

class DoctorTest : public GlTest {};

TEST_F(DoctorTest, FindsNothingWrongHere) {
    std::vector<std::string> parts;
    Examination examination;
    examination.speeds = false;
    examination.next = [&](const std::string& part) { parts.push_back(part); };
    const Diagnosis diagnosis = diagnose(examination);
    EXPECT_THAT(wrongOnes(diagnosis.findings), IsEmpty());
    EXPECT_EQ(diagnosis.debugErrors, 0);
    EXPECT_TRUE(diagnosis.right());
    EXPECT_THAT(diagnosis.verdict(), HasSubstr("works as it should"));
    EXPECT_GT(diagnosis.picture.width, 0);
    EXPECT_THAT(parts, ElementsAre("Sessions", "A cut", "Orders"));
    EXPECT_FALSE(diagnosis.limits.empty());
}

std::uintmax_t bytesIn(const fs::path& folder) {
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        bytes += entry.is_regular_file() ? entry.file_size() : 0;
    }
    return bytes;
}

// Where the editor finds them (docs/notes/first-minute.md).
TEST(DriverCache, TheExaminationLeavesTheKernelsOfAStrokeInIt) {
    KERF_BY_NIGHT();
    const test::TemporaryFolder folder;
    const fs::path cache = folder / "cache";
    fs::create_directory(cache);
    const std::map<std::string, std::string> there{{"MESA_SHADER_CACHE_DIR", cache.string()}};
    EXPECT_EQ(test::runKerf({"doctor", "--quick"}, there).exitCode, 0);
    const std::uintmax_t left = bytesIn(cache);
    if (left == 0) {
        GTEST_SKIP() << "this driver keeps its cache elsewhere";
    }
    const std::string session =
        std::string(KERF_SOURCE_DIR) + "/tests/regression/pulled-then-cut.kerf.json";
    EXPECT_EQ(test::runKerf({"replay", session, "--out", folder / "out"}, there).exitCode, 0);
    EXPECT_EQ(bytesIn(cache), left);
}

/// Shaders are those of a folder in which one has a fault, as if the driver compiled it so.
class FaultyDriver : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        fs::copy(gpu::shaderRoot(), folder_ / "shaders", fs::copy_options::recursive);
        fs::create_directory_symlink(gpu::dataPath("assets"), folder_ / "assets");
        data_.emplace("KERF_DATA_DIR", folder_.path().string());
    }
    void replaceIn(const std::string& shader, const std::string& right, const std::string& wrong) {
        const fs::path file = folder_ / "shaders" / shader;
        std::string text = readInputFile(file, 1 << 20);
        const std::size_t place = text.find(right);
        ASSERT_NE(place, std::string::npos) << shader << " has no " << right;
        writeText(file, text.replace(place, right.size(), wrong));
    }

    test::TemporaryFolder folder_;
    std::optional<Variable> data_;
};

TEST_F(FaultyDriver, AShaderThatDoesNotCompileIsAFinding) {
    replaceIn("sim/constraints/bend.glsl", "vec3 g1 = ", "vec4 g1 = ");
    Examination examination;
    examination.speeds = false;
    const Diagnosis diagnosis = diagnose(examination);
    EXPECT_THAT(wrongOnes(diagnosis.findings), Contains(HasSubstr("shaders that compile")));
    EXPECT_FALSE(diagnosis.right());
}

/// A shader that a driver got wrong, and the check that must tell.
struct Fault {
    const char* name;
    const char* shader;
    const char* right;
    const char* wrong;
    const char* session;  ///< "" for the cut
    const char* check;
    const char* kernels = "images";  ///< the way that has the fault
    bool byNight = false;            ///< it takes seconds until the check tells
};

std::ostream& operator<<(std::ostream& out, const Fault& fault) {
    return out << fault.name;
}

constexpr Fault kFaults[] = {
    {"ABarrierIsMissingInASum", "sim/measure.comp",
     "        barrier();\n        for (uint i = self", "        for (uint i = self", "bend",
     "A bent body", "shared"},
    {"ANumberOfADispatchIsLost", "sim/implicit/factors.comp", "setFactors(index, numbers.y)",
     "setFactors(index, 0u)", "pull", "A larger body"},
    {"ASignIsWrong", "sim/implicit/meet.comp", "Met(vec3(0.0, 1.0, 0.0), gap",
     "Met(vec3(0.0, -1.0, 0.0), gap", "floor", "On the floor"},
    {"AFactorIsWrong", "sim/implicit/factors.comp", "vec3 g1 = sA * a", "vec3 g1 = 0.9 * sA * a",
     "bend", "A bent body"},
    {"TheLastGroupIsMissing", "sim/implicit/forces.comp", "if (v >= implicit.vertex_count) return;",
     "if (v >= implicit.vertex_count - implicit.vertex_count % 32u) return;", "pull",
     "A larger body"},
    {"AnIndexIsWrong", "sim/gather_corrections.comp", "* correctionAt(pair.z).xyz;",
     "* correctionAt(pair.z + 1u).xyz;", "plain-pbd", "A pulled body"},
    {"AnAnswerToContactIsTurned", "sim/implicit/contact_rows.glsl", "stiffness * max(-gap, 0.0)",
     "stiffness * min(gap, 0.0)", "halves", "A half on the other", "images", true},
    {"AFaceOfABoxIsMistaken", "sim/implicit/meet_obstacles.comp", "normal[face.axis] = face.side;",
     "normal[face.axis] = -face.side;", "box", "On a box", "images", true},
    {"AHandPushesWhereItPulls", "sim/implicit/pulls.comp", "* (x.xyz - target)",
     "* (target - x.xyz)", "hold", "in a hand", "images", true},
    {"NormalsPointInwards", "render/normals.comp", "vec3 n = cross(u, v);", "vec3 n = cross(v, u);",
     "", "Picture", "images", true},
};

class FaultyKernel : public FaultyDriver, public ::testing::WithParamInterface<Fault> {};

TEST_P(FaultyKernel, IsFound) {
    const Fault& fault = GetParam();
    if (fault.byNight) {
        KERF_BY_NIGHT();
    }
    replaceIn(fault.shader, fault.right, fault.wrong);
    const Variable kernels("KERF_KERNELS", fault.kernels);
    const bool ofCut = std::string_view(fault.session).empty();
    EXPECT_THAT(wrongOnes(ofCut ? cutFindings().findings : sessionFindings(fault.session)),
                Contains(HasSubstr(fault.check)));
}

INSTANTIATE_TEST_SUITE_P(Of, FaultyKernel, ::testing::ValuesIn(kFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST_F(FaultyDriver, AFormOfKernelsThatBreaksIsFound) {
    replaceIn("doctor/forms.comp", "if (self == i) ++counted;", "");
    EXPECT_THAT(
        wrongOnes(formFindings()),
        ElementsAre("A count by one thread at a time, with barriers in a loop: 0, asked 128"));
}

// With KERF_RENEW they are written anew instead.
TEST_F(DoctorTest, ShortSessionsEndAsExpected) {
    for (const ShortSession& session : shortSessions()) {
        if (std::getenv("KERF_RENEW") != nullptr) {
            writeText(expectedPieces(session), formatPieces(playShortSession(session)));
        } else {
            EXPECT_THAT(wrongOnes(sessionFindings(session.name)), IsEmpty());
        }
    }
}

TEST_F(DoctorTest, ModelsHaveARealTimeFactorWithoutPictures) {
    const std::vector<ModelSpeed> speeds = modelSpeeds(0.5);
    EXPECT_EQ(speeds.size(), 5u);
    for (const ModelSpeed& speed : speeds) {
        if (speed.frames == 0) {
            continue;  // too slow to be timed
        }
        EXPECT_GT(speed.realTime.worst(), 0) << speed.model;
        EXPECT_LE(speed.realTime.worst(), speed.realTime.median()) << speed.model;
        EXPECT_GT(speed.realTime.withDrawing(), 0) << speed.model;
    }
}

TEST(DriverLimits, WhatIsLackingIsNamedWithWhatIsNeeded) {
    std::vector<gpu::DriverLimit> limits{{"GL_A", "storage buffers", 16, 16},
                                         {"GL_B", "images", 4, 8}};
    EXPECT_THAT(gpu::sentenceOfLack(limits), HasSubstr("4 images of 8"));
    EXPECT_THAT(gpu::sentenceOfLack(limits), Not(HasSubstr("storage")));
    limits.back().has = 8;
    EXPECT_EQ(gpu::sentenceOfLack(limits), "");
}

TEST(Diagnosis, OneWrongFindingIsEnough) {
    Diagnosis diagnosis;
    diagnosis.findings = {{"Edges", "1 m", "0 m", true}};
    EXPECT_TRUE(diagnosis.right());
    diagnosis.findings.push_back({"Bends", "1 m", "0 m", false});
    EXPECT_FALSE(diagnosis.right());
    EXPECT_THAT(diagnosis.verdict(), HasSubstr("LIBGL_ALWAYS_SOFTWARE=1"));
    diagnosis.findings.pop_back();
    diagnosis.debugErrors = 1;
    EXPECT_FALSE(diagnosis.right());
}

// Faults that drivers have had, or may have, stand between Kerf and OpenGL: kerf doctor must find
// each.

using ::testing::AllOf;

/// What a fault stands before.
struct Functions {
    PFNGLNAMEDBUFFERSUBDATAPROC subData = glad_glNamedBufferSubData;
    PFNGLCOPYNAMEDBUFFERSUBDATAPROC copy = glad_glCopyNamedBufferSubData;
    PFNGLCLEARNAMEDBUFFERSUBDATAPROC clear = glad_glClearNamedBufferSubData;
    PFNGLGETNAMEDBUFFERSUBDATAPROC get = glad_glGetNamedBufferSubData;
    PFNGLDISPATCHCOMPUTEPROC dispatch = glad_glDispatchCompute;
    PFNGLMEMORYBARRIERPROC barrier = glad_glMemoryBarrier;
    PFNGLGETINTEGERI_VPROC limit = glad_glGetIntegeri_v;
};
Functions driver;
std::function<void()> late;  // a command whose effect comes after that of the next one

void comeLate() {
    if (late) {
        std::exchange(late, nullptr)();
    }
}

class OrderFindings : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        driver = Functions();
        glad_glCopyNamedBufferSubData = [](auto... all) {
            comeLate();
            driver.copy(all...);
        };
        glad_glGetNamedBufferSubData = [](auto... all) {
            comeLate();
            driver.get(all...);
        };
    }
    void TearDown() override {
        comeLate();
        glad_glNamedBufferSubData = driver.subData;
        glad_glCopyNamedBufferSubData = driver.copy;
        glad_glClearNamedBufferSubData = driver.clear;
        glad_glGetNamedBufferSubData = driver.get;
        glad_glDispatchCompute = driver.dispatch;
        glad_glMemoryBarrier = driver.barrier;
        glad_glGetIntegeri_v = driver.limit;
        GlTest::TearDown();
    }
    static std::vector<std::string> wrong() { return wrongOnes(orderFindings({4, 4096})); }
};

TEST_F(OrderFindings, AreRightHere) {
    EXPECT_THAT(wrong(), IsEmpty());
    EXPECT_THAT(wrongOnes(formFindings()), IsEmpty());
}

// As NVIDIA's 580.159 did (docs/notes/drivers.md).
TEST_F(OrderFindings, TellOfAClearThatComesAfterTheNextWrite) {
    glad_glClearNamedBufferSubData = [](GLuint buffer, GLenum format, GLintptr first,
                                        GLsizeiptr bytes, GLenum words, GLenum type,
                                        const void* data) {
        comeLate();
        GLint mapped = 0;
        glGetNamedBufferParameteriv(buffer, GL_BUFFER_MAPPED, &mapped);
        if (mapped != 0) {  // the mark of a ReadBack, which would wait for it
            driver.clear(buffer, format, first, bytes, words, type, data);
            return;
        }
        late = [=, value = *static_cast<const std::uint32_t*>(data)] {
            if (glIsBuffer(buffer) == GL_TRUE) {
                driver.clear(buffer, format, first, bytes, words, type, &value);
            }
        };
    };
    glad_glNamedBufferSubData = [](auto... all) {
        driver.subData(all...);
        comeLate();
    };
    glad_glDispatchCompute = [](auto... all) {
        driver.dispatch(all...);
        comeLate();
    };
    const std::vector<std::string> found = wrong();
    for (const char* write : {"A write by glNamedBufferSubData()", "A write by a kernel"}) {
        for (const char* format : {"GL_R8UI", "GL_R32UI"}) {
            EXPECT_THAT(found, Contains(AllOf(HasSubstr(write), HasSubstr("after a clear"),
                                              HasSubstr(format), HasSubstr("lost"),
                                              HasSubstr("4 bytes and 4 KB"))));
        }
    }
    // As docs/gpus.md has it.
    EXPECT_THAT(found,
                Contains("A write by glNamedBufferSubData() after a clear by "
                         "glClearNamedBufferSubData(GL_R8UI): lost in buffers of 4 bytes and 4 KB, "
                         "as seen by a kernel, a uniform block, an indirect dispatch, "
                         "glGetNamedBufferSubData(), mapped memory and texels, asked what was "
                         "written last"));
    EXPECT_THAT(found, Not(Contains(HasSubstr("after a copy"))));
}

TEST_F(OrderFindings, TellOfAWriteThatTheNextKernelDoesNotSee) {
    glad_glNamedBufferSubData = [](GLuint buffer, GLintptr first, GLsizeiptr bytes,
                                   const void* data) {
        comeLate();
        const auto* const from = static_cast<const std::byte*>(data);
        late = [=, copy = std::vector<std::byte>(from, from + bytes)] {
            if (glIsBuffer(buffer) == GL_TRUE) {
                driver.subData(buffer, first, bytes, copy.data());
            }
        };
    };
    glad_glDispatchCompute = [](auto... all) {
        driver.dispatch(all...);
        comeLate();
    };
    EXPECT_THAT(wrong(), Contains(AllOf(HasSubstr("glNamedBufferSubData()"), HasSubstr("lost"),
                                        HasSubstr("a kernel"))));
}

GLbitfield ignoredBarriers = 0;
GLbitfield passedBarriers = 0;  // since the last kernel

/// A kernel's writes come with the next command that no barrier lets wait.
void writeKernelsLate() {
    glad_glDispatchCompute = [](auto... all) {
        comeLate();
        driver.dispatch(all...);
        passedBarriers = 0;
        late = [=] { driver.dispatch(all...); };
    };
    glad_glMemoryBarrier = [](GLbitfield bits) {
        driver.barrier(bits);
        passedBarriers |= bits & ~ignoredBarriers;
        if ((passedBarriers & GL_BUFFER_UPDATE_BARRIER_BIT) != 0) {
            comeLate();
        }
    };
    glad_glNamedBufferSubData = [](auto... all) {
        driver.subData(all...);
        comeLate();
    };
    glad_glClearNamedBufferSubData = [](auto... all) {
        driver.clear(all...);
        comeLate();
    };
}

TEST_F(OrderFindings, HaveTheBarriersThatADriverMayAskFor) {
    ignoredBarriers = 0;
    writeKernelsLate();
    EXPECT_THAT(wrong(), IsEmpty());
}

TEST_F(OrderFindings, TellOfABarrierThatDoesNotWork) {
    ignoredBarriers = GL_BUFFER_UPDATE_BARRIER_BIT;
    writeKernelsLate();
    const std::vector<std::string> found = wrong();
    for (const char* write : {"A write by glNamedBufferSubData()", "A clear by"}) {
        EXPECT_THAT(found, Contains(AllOf(HasSubstr(write), HasSubstr("after a write by a kernel"),
                                          HasSubstr("lost"))));
    }
}

TEST_F(OrderFindings, TellOfWorkGroupsThatAreLeftOut) {
    glad_glGetIntegeri_v = [](GLenum name, GLuint index, GLint* value) {
        driver.limit(name, index, value);
        *value = name == GL_MAX_COMPUTE_WORK_GROUP_COUNT ? 1 << 20 : *value;
    };
    glad_glDispatchCompute = [](GLuint x, GLuint y, GLuint z) {
        driver.dispatch(x & 0xffff, y, z);
    };
    EXPECT_THAT(wrongOnes(formFindings()), Contains("Work groups at once: 4464, asked 70000"));
}

}  // namespace
}  // namespace kerf::app
