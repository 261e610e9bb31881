// C++ and the driver must agree on where each member of a shared record lies.
#include <glad/gl.h>

#include <array>
#include <cstddef>
#include <string>

#include "gpu/program.h"
#include "shaders/shared/constraints.h"
#include "tests/support/gl_fixture.h"

namespace kerf::gpu {
namespace {

struct DriverLayout {
    GLint offset = -1;
    GLint stride = -1;
};

class Layout : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        program_ =
            Program::compute(std::string(KERF_SOURCE_DIR) + "/tests/gpu/shaders/layout.comp");
    }

    void expect(const std::string& variable, std::size_t offset, std::size_t stride) {
        SCOPED_TRACE(variable);
        const DriverLayout layout = ask(variable);
        EXPECT_EQ(layout.offset, static_cast<GLint>(offset));
        EXPECT_EQ(layout.stride, static_cast<GLint>(stride));
    }

  private:
    DriverLayout ask(const std::string& variable) const {
        const GLuint index =
            glGetProgramResourceIndex(program_.id(), GL_BUFFER_VARIABLE, variable.c_str());
        if (index == GL_INVALID_INDEX) {
            return {};
        }
        const std::array<GLenum, 2> asked = {GL_OFFSET, GL_TOP_LEVEL_ARRAY_STRIDE};
        std::array<GLint, 2> answer{};
        glGetProgramResourceiv(program_.id(), GL_BUFFER_VARIABLE, index, 2, asked.data(), 2,
                               nullptr, answer.data());
        return {answer[0], answer[1]};
    }

    Program program_;
};

#define EXPECT_SAME_LAYOUT(array, Record, member) \
    expect(array "[0]." #member, offsetof(shared::Record, member), sizeof(shared::Record))

TEST_F(Layout, EdgeConstraint) {
    EXPECT_SAME_LAYOUT("edges", EdgeConstraint, a);
    EXPECT_SAME_LAYOUT("edges", EdgeConstraint, b);
    EXPECT_SAME_LAYOUT("edges", EdgeConstraint, rest_length);
    EXPECT_SAME_LAYOUT("edges", EdgeConstraint, geometry);
}

TEST_F(Layout, BendConstraint) {
    EXPECT_SAME_LAYOUT("bends", BendConstraint, v0);
    EXPECT_SAME_LAYOUT("bends", BendConstraint, v1);
    EXPECT_SAME_LAYOUT("bends", BendConstraint, v2);
    EXPECT_SAME_LAYOUT("bends", BendConstraint, v3);
    EXPECT_SAME_LAYOUT("bends", BendConstraint, rest_angle);
    EXPECT_SAME_LAYOUT("bends", BendConstraint, geometry);
}

TEST_F(Layout, IspcConstraint) {
    EXPECT_SAME_LAYOUT("ispcs", IspcConstraint, vertex);
    EXPECT_SAME_LAYOUT("ispcs", IspcConstraint, t0);
    EXPECT_SAME_LAYOUT("ispcs", IspcConstraint, t1);
    EXPECT_SAME_LAYOUT("ispcs", IspcConstraint, t2);
    EXPECT_SAME_LAYOUT("ispcs", IspcConstraint, b1);
    EXPECT_SAME_LAYOUT("ispcs", IspcConstraint, b2);
    EXPECT_SAME_LAYOUT("ispcs", IspcConstraint, rest_length);
    EXPECT_SAME_LAYOUT("ispcs", IspcConstraint, geometry);
}

}  // namespace
}  // namespace kerf::gpu
