// C++ and the driver must agree on where each member of a shared record lies.

#include <ostream>

#include "gpu/program.h"
#include "shaders/shared/blade_records.h"
#include "shaders/shared/body_records.h"
#include "shaders/shared/box_records.h"
#include "shaders/shared/constraints.h"
#include "shaders/shared/contact_records.h"
#include "shaders/shared/edge_records.h"
#include "shaders/shared/implicit_records.h"
#include "shaders/shared/skin_records.h"
#include "shaders/shared/solver_uniforms.h"
#include "shaders/shared/unfold_records.h"

namespace kerf::gpu {
namespace {

/// A member of a record, as the C++ compiler laid it out. An array goes by its first element.
struct Member {
    std::string name;
    std::size_t offset;  // [bytes]
};

struct Record {
    std::string name;
    std::size_t size;  // [bytes]
    std::vector<Member> members;
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for.
void PrintTo(const Record& record, std::ostream* out) {
    *out << record.name;
}

#define RECORD(Name, ...)                                  \
    [] {                                                   \
        using Laid = shared::Name;                         \
        return Record{#Name, sizeof(Laid), {__VA_ARGS__}}; \
    }()
#define AT(name)                    \
    Member {                        \
#name, offsetof(Laid, name) \
    }

/// All records of shaders/shared with all of their members.
std::vector<Record> sharedRecords() {
    return {
        RECORD(SkinCorner, AT(u), AT(v), AT(red_green), AT(blue_own)),
        RECORD(SkinRecord, AT(triangle), AT(first.u), AT(first.v), AT(first.red_green),
               AT(first.blue_own), AT(second.u), AT(second.v), AT(second.red_green),
               AT(second.blue_own), AT(third.u), AT(third.v), AT(third.red_green),
               AT(third.blue_own)),
        RECORD(BladeRecord, AT(box.center), AT(box.x), AT(box.y), AT(box.z), AT(shift), AT(turn),
               AT(bevel)),
        RECORD(VertexLoad, AT(given), AT(moment)),
        RECORD(EdgeUniforms, AT(from), AT(to), AT(ahead), AT(lag), AT(way), AT(inverse_density),
               AT(vertex_count)),
        RECORD(EdgeState, AT(middle), AT(inverse), AT(gone), AT(impulse), AT(work)),
        RECORD(VertexLinks, AT(counts[0]), AT(piece)),
        RECORD(PieceRecord, AT(origin), AT(first_block), AT(block_count), AT(constrained),
               AT(target_volume), AT(mass_per_area), AT(least_area)),
        RECORD(BlockRecord, AT(piece), AT(first_page), AT(page_count)),
        RECORD(IncidenceRange, AT(first), AT(end)),
        RECORD(Spoke, AT(other), AT(rest_length), AT(geometry), AT(other_count)),
        RECORD(BendRecord, AT(v0), AT(v1), AT(v2), AT(v3), AT(rest_cosine), AT(rest_sine),
               AT(geometry), AT(steepness)),
        RECORD(BendRange, AT(first), AT(apexes), AT(end), AT(unused)),
        RECORD(ConstraintShare, AT(constraint), AT(weight)),
        RECORD(WordWrite, AT(word), AT(value)),
        RECORD(PullRecord, AT(vertex), AT(target_x), AT(target_y), AT(target_z), AT(motion_x),
               AT(motion_y), AT(motion_z), AT(leads)),
        RECORD(BlockMeasure, AT(low_volume), AT(high_stretch), AT(low_velocity_kinetic),
               AT(high_velocity_potential), AT(low_drift_strain), AT(high_drift)),
        RECORD(NearbyQuery, AT(center), AT(first_axis), AT(second_axis), AT(third_axis),
               AT(asks_for_box), AT(asked_vertices), AT(capacity), AT(count), AT(unused_a),
               AT(unused_b), AT(unused_c), AT(unused_d)),
        RECORD(NearbyVertex, AT(vertex), AT(x), AT(y), AT(z), AT(vx), AT(vy), AT(vz), AT(unused)),
        RECORD(BoxUniforms, AT(thickness), AT(depth), AT(lift), AT(push), AT(friction),
               AT(inverse_density), AT(unit), AT(floor_height), AT(vertex_count),
               AT(triangle_count), AT(box_count)),
        RECORD(BoxRecord, AT(center), AT(x), AT(y), AT(z)),
        RECORD(PieceBounds, AT(low_x), AT(low_y), AT(low_z), AT(high_x), AT(high_y), AT(high_z)),
        RECORD(BoxTouch, AT(normal), AT(impulse), AT(weights)),
        RECORD(BoxPlanes, AT(first), AT(second), AT(third)),
        RECORD(IspcConstraint, AT(vertex), AT(t0), AT(t1), AT(t2), AT(b1), AT(b2), AT(rest_length),
               AT(geometry)),
        RECORD(ContactUniforms, AT(h), AT(reach), AT(interval), AT(margin), AT(thickness),
               AT(substep), AT(lift_speed), AT(friction), AT(inverse_density), AT(unit),
               AT(vertex_count), AT(triangle_count)),
        RECORD(ContactCandidate, AT(triangle), AT(thickness)),
        RECORD(PaperRequest, AT(loss_x), AT(loss_y), AT(loss_z), AT(push_x), AT(push_y), AT(push_z),
               AT(count)),
        RECORD(EdgePair, AT(other), AT(edge), AT(thickness)),
        RECORD(ContactRecord, AT(normal), AT(impulse), AT(gains), AT(v0), AT(v1), AT(v2), AT(v3)),
        RECORD(ContactState, AT(point_groups), AT(point_groups_y), AT(point_groups_z),
               AT(vertex_groups), AT(vertex_groups_y), AT(vertex_groups_z), AT(points),
               AT(contacts), AT(last_contacts), AT(fitted_groups)),
        RECORD(SolverUniforms, AT(gravity), AT(substep), AT(drag_factor), AT(inverse_density),
               AT(substeps), AT(modulus[0]), AT(share[0]), AT(count[0]), AT(friction),
               AT(floor_height), AT(lift_speed), AT(active_parts), AT(sweeps), AT(vertex_count),
               AT(triangle_count), AT(piece_count), AT(pull_count), AT(runaway_speed),
               AT(catch_up_speed)),
        RECORD(ImplicitContact, AT(friction), AT(floor_height), AT(reach), AT(stiffness),
               AT(let_out)),
        RECORD(ImplicitBounds, AT(firmest), AT(close), AT(unused_a), AT(unused_b)),
        RECORD(ImplicitUniforms, AT(gravity), AT(stage), AT(inertia), AT(rest), AT(damping),
               AT(kept), AT(inverse_density), AT(modulus[0]), AT(step), AT(contact.friction),
               AT(contact.floor_height), AT(contact.reach), AT(contact.stiffness),
               AT(contact.let_out), AT(vertex_count), AT(block_count), AT(patch_count),
               AT(aggregate_count), AT(page_count), AT(piece_count), AT(holds_volume),
               AT(region_count), AT(bounds.firmest), AT(bounds.close), AT(bounds.unused_a),
               AT(bounds.unused_b)),
        RECORD(ImplicitBlock, AT(place), AT(column), AT(first), AT(end)),
        RECORD(ImplicitAggregate, AT(first), AT(end), AT(piece), AT(coarse)),
        RECORD(ImplicitRegion, AT(first), AT(end), AT(members_first), AT(members_end), AT(of_piece),
               AT(piece_count), AT(coarse), AT(unused)),
        RECORD(ImplicitMember, AT(vertex), AT(patch_number), AT(neighbours), AT(inverse)),
        RECORD(ImplicitPiece, AT(first_page), AT(page_count), AT(first_aggregate),
               AT(aggregate_count), AT(root), AT(next), AT(row_count), AT(force_unit)),
        RECORD(ContactRow, AT(normal), AT(slip), AT(weights), AT(lead)),
        RECORD(RowState, AT(slip), AT(push)),
        RECORD(AggregateMotion, AT(middle), AT(ended_middle), AT(momentum), AT(ended_momentum),
               AT(turn), AT(ended_turn), AT(squares), AT(mixed)),
        RECORD(Course, AT(beta), AT(pressure), AT(size), AT(gamma), AT(scale), AT(done), AT(ended),
               AT(groups), AT(shift)),
        RECORD(Reach, AT(alpha), AT(pressure), AT(missing), AT(swelling)),
        RECORD(ProductSums, AT(direction_image), AT(pressure_image), AT(gradient_direction),
               AT(direction_residual), AT(pressure_residual), AT(residual_answer),
               AT(gradient_pressure), AT(scale)),
        RECORD(AnswerSums, AT(left_answer), AT(gradient_answer), AT(before_answer),
               AT(left_pressure), AT(rest)),
        RECORD(UnfoldGoal, AT(rotation), AT(center), AT(rest_center), AT(velocity), AT(spin)),
    };
}

class Layout : public GlTest, public ::testing::WithParamInterface<Record> {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        program_ = Program::compute(std::string(KERF_SOURCE_DIR) + "/tests/gpu/shaders/layout.comp",
                                    {{"RECORD", GetParam().name}});
    }

    struct DriverLayout {
        GLint offset = -1;
        GLint stride = -1;
    };

    GLint memberCount() const {
        const GLuint block =
            glGetProgramResourceIndex(program_.id(), GL_SHADER_STORAGE_BLOCK, "Records");
        const GLenum asked = GL_NUM_ACTIVE_VARIABLES;
        GLint count = 0;
        glGetProgramResourceiv(program_.id(), GL_SHADER_STORAGE_BLOCK, block, 1, &asked, 1, nullptr,
                               &count);
        return count;
    }

    DriverLayout ask(const std::string& member) const {
        const GLuint index = glGetProgramResourceIndex(program_.id(), GL_BUFFER_VARIABLE,
                                                       ("records[0]." + member).c_str());
        if (index == GL_INVALID_INDEX) {
            return {};
        }
        const std::array<GLenum, 2> asked = {GL_OFFSET, GL_TOP_LEVEL_ARRAY_STRIDE};
        std::array<GLint, 2> answer{};
        glGetProgramResourceiv(program_.id(), GL_BUFFER_VARIABLE, index, 2, asked.data(), 2,
                               nullptr, answer.data());
        return {answer[0], answer[1]};
    }

  private:
    Program program_;
};

TEST_P(Layout, IsThatOfTheDriver) {
    EXPECT_EQ(memberCount(), static_cast<GLint>(GetParam().members.size()))
        << "list every member in sharedRecords()";
    for (const Member& member : GetParam().members) {
        SCOPED_TRACE(member.name);
        const DriverLayout layout = ask(member.name);
        EXPECT_EQ(layout.offset, static_cast<GLint>(member.offset));
        EXPECT_EQ(layout.stride, static_cast<GLint>(GetParam().size));
    }
}

INSTANTIATE_TEST_SUITE_P(EachRecord, Layout, ::testing::ValuesIn(sharedRecords()),
                         [](const auto& record) { return record.param.name; });

TEST(LayoutList, HasEveryRecordOfTheSharedHeaders) {
    std::vector<std::string> listed;
    for (const Record& record : sharedRecords()) {
        listed.push_back(record.name);
    }
    std::vector<std::string> declared;
    const std::regex record("^struct (\\w+) \\{");  // shared_types.h declares aligned words alone
    const fs::path folder = fs::path(KERF_SOURCE_DIR) / "shaders/shared";
    for (const auto& header : fs::directory_iterator(folder)) {
        std::ifstream in(header.path());
        std::smatch match;
        for (std::string line; std::getline(in, line);) {
            if (std::regex_search(line, match, record)) {
                declared.push_back(match[1]);
            }
        }
    }
    std::ranges::sort(listed);
    std::ranges::sort(declared);
    EXPECT_EQ(listed, declared) << "list every record in sharedRecords()";
}

}  // namespace
}  // namespace kerf::gpu
