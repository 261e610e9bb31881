#include "app/doctor/doctor.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "app/doctor/kernel_findings.h"
#include "app/files/file_io.h"
#include "gpu/data_path.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

namespace fs = std::filesystem;

class DoctorTest : public test::GlTest {};

std::vector<std::string> wrongOnes(const std::vector<DriverFinding>& findings) {
    std::vector<std::string> wrong;
    for (const DriverFinding& finding : findings) {
        if (!finding.right) {
            wrong.push_back(finding.check + ": " + finding.seen + ", asked " + finding.asked);
        }
    }
    return wrong;
}

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
    EXPECT_EQ(parts.size(), 4u);
    EXPECT_FALSE(diagnosis.limits.empty());
}

/// Shaders are those of a folder in which one has a fault, as if the driver compiled it so.
class FaultyDriver : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        fs::copy(gpu::shaderRoot(), folder_ / "shaders", fs::copy_options::recursive);
        fs::create_directory_symlink(gpu::dataPath("assets"), folder_ / "assets");
        setenv("KERF_DATA_DIR", folder_.path().c_str(), 1);
    }
    void TearDown() override {
        unsetenv("KERF_DATA_DIR");
        GlTest::TearDown();
    }
    void replaceIn(const std::string& shader, const std::string& right, const std::string& wrong) {
        const fs::path file = folder_ / "shaders" / shader;
        std::string text = readInputFile(file, 1 << 20);
        const std::size_t place = text.find(right);
        ASSERT_NE(place, std::string::npos) << shader << " has no " << right;
        test::writeText(file, text.replace(place, right.size(), wrong));
    }

    test::TemporaryFolder folder_;
};

TEST_F(FaultyDriver, AKernelThatIsWrongIsFoundByItsName) {
    replaceIn("sim/constraints/bend.glsl", "vec3 g1 = sA * a", "vec3 g1 = 0.9 * sA * a");
    EXPECT_THAT(wrongOnes(kernelFindings()), Contains(HasSubstr("Bends, ")));
}

TEST_F(FaultyDriver, AShaderThatDoesNotCompileIsAFinding) {
    replaceIn("sim/constraints/bend.glsl", "vec3 g1 = ", "vec4 g1 = ");
    Examination examination;
    examination.speeds = false;
    const Diagnosis diagnosis = diagnose(examination);
    EXPECT_THAT(wrongOnes(diagnosis.findings), Contains(HasSubstr("shaders that compile")));
    EXPECT_FALSE(diagnosis.right());
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
