#include "app/doctor/doctor.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <ostream>

#include "app/doctor/findings.h"
#include "app/files/io/file_io.h"
#include "gpu/data_path.h"
#include "tests/app/doctor/wrong_findings.h"
#include "tests/paths.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/nightly.h"
#include "tests/support/run_kerf.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/variable.h"

namespace kerf::app {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

namespace fs = std::filesystem;

class DoctorTest : public test::GlTest {};

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
class FaultyDriver : public test::GlTest {
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
        test::writeText(file, text.replace(place, right.size(), wrong));
    }

    test::TemporaryFolder folder_;
    std::optional<test::Variable> data_;
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
    const test::Variable kernels("KERF_KERNELS", fault.kernels);
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
            test::writeText(expectedPieces(session), formatPieces(playShortSession(session)));
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

}  // namespace
}  // namespace kerf::app
