// C++ and the driver must agree on where each member of a shared record lies.
#include <glad/gl.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "gpu/program.h"
#include "shaders/shared/body_records.h"
#include "shaders/shared/constraints.h"
#include "shaders/shared/solver_uniforms.h"
#include "tests/paths.h"
#include "tests/support/gl_fixture.h"

namespace kerf::gpu {
namespace {

/// A member of a record, as the C++ compiler laid it out.
struct Member {
    std::string name;
    std::size_t offset;  // [bytes]
};

class Layout : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        program_ =
            Program::compute(std::string(KERF_SOURCE_DIR) + "/tests/gpu/shaders/layout.comp");
    }

    /// `members` must be all of those that the driver knows in the array `array` of `block`.
    void expectSame(const std::string& block, const std::string& array, std::size_t recordSize,
                    const std::vector<Member>& members) const {
        EXPECT_EQ(memberCount(block), static_cast<GLint>(members.size()))
            << "list every member here";
        for (const Member& member : members) {
            SCOPED_TRACE(member.name);
            const DriverLayout layout = ask(array + "[0]." + member.name);
            EXPECT_EQ(layout.offset, static_cast<GLint>(member.offset));
            EXPECT_EQ(layout.stride, static_cast<GLint>(recordSize));
        }
    }

  private:
    struct DriverLayout {
        GLint offset = -1;
        GLint stride = -1;
    };

    GLint memberCount(const std::string& block) const {
        const GLuint index =
            glGetProgramResourceIndex(program_.id(), GL_SHADER_STORAGE_BLOCK, block.c_str());
        const GLenum asked = GL_NUM_ACTIVE_VARIABLES;
        GLint count = 0;
        glGetProgramResourceiv(program_.id(), GL_SHADER_STORAGE_BLOCK, index, 1, &asked, 1, nullptr,
                               &count);
        return count;
    }

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

#define MEMBER(Record, name) \
    { #name, offsetof(shared::Record, name) }

TEST_F(Layout, Spoke) {
    expectSame("Spokes", "spokes", sizeof(shared::Spoke),
               {MEMBER(Spoke, other), MEMBER(Spoke, rest_length), MEMBER(Spoke, geometry),
                MEMBER(Spoke, other_count)});
}

TEST_F(Layout, BendRecord) {
    expectSame(
        "Bends", "bends", sizeof(shared::BendRecord),
        {MEMBER(BendRecord, v0), MEMBER(BendRecord, v1), MEMBER(BendRecord, v2),
         MEMBER(BendRecord, v3), MEMBER(BendRecord, rest_cosine), MEMBER(BendRecord, rest_sine),
         MEMBER(BendRecord, geometry), MEMBER(BendRecord, unused)});
}

TEST_F(Layout, IspcConstraint) {
    expectSame(
        "Ispcs", "ispcs", sizeof(shared::IspcConstraint),
        {MEMBER(IspcConstraint, vertex), MEMBER(IspcConstraint, t0), MEMBER(IspcConstraint, t1),
         MEMBER(IspcConstraint, t2), MEMBER(IspcConstraint, b1), MEMBER(IspcConstraint, b2),
         MEMBER(IspcConstraint, rest_length), MEMBER(IspcConstraint, geometry)});
}

TEST_F(Layout, VertexLinks) {
    expectSame("Links", "links", sizeof(shared::VertexLinks),
               {MEMBER(VertexLinks, edges), MEMBER(VertexLinks, bends), MEMBER(VertexLinks, ispcs),
                MEMBER(VertexLinks, piece)});
}

TEST_F(Layout, PieceRecord) {
    expectSame("Pieces", "pieces", sizeof(shared::PieceRecord),
               {MEMBER(PieceRecord, origin), MEMBER(PieceRecord, first_block),
                MEMBER(PieceRecord, block_count), MEMBER(PieceRecord, constrained),
                MEMBER(PieceRecord, target_volume), MEMBER(PieceRecord, mass_per_area),
                MEMBER(PieceRecord, least_area)});
}

TEST_F(Layout, BlockRecord) {
    expectSame("Blocks", "blocks", sizeof(shared::BlockRecord),
               {MEMBER(BlockRecord, piece), MEMBER(BlockRecord, first_page),
                MEMBER(BlockRecord, page_count)});
}

TEST_F(Layout, VolumeSum) {
    expectSame("VolumeSums", "volumeSums", sizeof(shared::VolumeSum),
               {MEMBER(VolumeSum, volume), MEMBER(VolumeSum, denominator)});
}

TEST_F(Layout, BlockMeasure) {
    expectSame(
        "Measures", "measures", sizeof(shared::BlockMeasure),
        {MEMBER(BlockMeasure, low_volume), MEMBER(BlockMeasure, high_lost),
         MEMBER(BlockMeasure, low_velocity_kinetic), MEMBER(BlockMeasure, high_velocity_potential),
         MEMBER(BlockMeasure, low_drift_strain), MEMBER(BlockMeasure, high_drift)});
}

TEST_F(Layout, SolverUniforms) {
    expectSame("Uniforms", "uniforms", sizeof(shared::SolverUniforms),
               {MEMBER(SolverUniforms, gravity),         MEMBER(SolverUniforms, substep),
                MEMBER(SolverUniforms, drag_factor),     MEMBER(SolverUniforms, inverse_density),
                MEMBER(SolverUniforms, damping_ratio),   MEMBER(SolverUniforms, stretch_compliance),
                MEMBER(SolverUniforms, bend_compliance), MEMBER(SolverUniforms, ispc_compliance),
                MEMBER(SolverUniforms, friction),        MEMBER(SolverUniforms, floor_height),
                MEMBER(SolverUniforms, lift_speed),      MEMBER(SolverUniforms, active_parts),
                MEMBER(SolverUniforms, substeps),        MEMBER(SolverUniforms, sweeps),
                MEMBER(SolverUniforms, stretch_share),   MEMBER(SolverUniforms, bend_share),
                MEMBER(SolverUniforms, ispc_share),      MEMBER(SolverUniforms, vertex_count),
                MEMBER(SolverUniforms, edge_count),      MEMBER(SolverUniforms, bend_count),
                MEMBER(SolverUniforms, ispc_count),      MEMBER(SolverUniforms, triangle_count),
                MEMBER(SolverUniforms, piece_count),     MEMBER(SolverUniforms, pull_count),
                MEMBER(SolverUniforms, runaway_speed)});
}

}  // namespace
}  // namespace kerf::gpu
