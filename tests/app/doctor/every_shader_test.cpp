// Every shader that Kerf can come to compile, seen by the reference compiler of GLSL and held
// against what Kerf asks of a driver.

#include <glad/gl.h>

#include <cctype>

#include "gpu/context.h"
#include "render/renderer.h"
#include "sim/body/solver_uniforms.h"
#include "sim/contact/contact_solver.h"
#include "sim/mesh/triangle_soup.h"
#include "sim/solve/float_vectors.h"
#include "sim/solve/gpu_solver.h"
#include "sim/solve/implicit/vertex_groups.h"
#include "sim/solve/implicit_stepper.h"

namespace kerf::app {
namespace {

/// Two boxes of a metre, one above the other, that overlap a little: a body that needs the kernels
/// of contact.
SurfaceMesh touchingBoxes() {
    const TriangleSoup box = test::boxSoup(Vec3::Ones(), 2);
    return test::meshOf(test::joined(box, box, Vec3(0, 0.95, 0)));
}

/// A body, and how it is solved.
struct Case {
    SurfaceMesh mesh;
    Params params;
    bool folded = false;
};

Params paramsOf(SolverMode mode, bool paperContact) {
    Params params;
    params.solver = mode;
    params.floor = -0.5;
    params.paperContact = paperContact ? 1 : 0;
    return params;
}

/// Thin, so that it may pierce the skin.
StaticBox plate() {
    StaticBox box;
    box.size = Vec3(2, 1e-3, 2);
    return box;
}

/// So thick that nothing pierces it.
StaticBox block() {
    StaticBox box = plate();
    box.size = Vec3(2, 1, 2);
    return box;
}

BladeMotion standingBlade() {
    BladeFrame frame;
    frame.halfLength = 1;
    BladeMotion motion;
    motion.frames = {frame, frame};
    motion.back = 1;
    motion.bevel = 0.1;
    motion.halfThickness = 0.01;
    return motion;
}

PressingEdge pressingEdge() {
    PressingEdge edge;
    edge.to = Vec3::UnitX();
    edge.ahead = -Vec3::UnitY();
    edge.reach = edge.stiffness = edge.mostForce = 1;
    return edge;
}

/// A step of a body that meets all that bodies meet, so that it asks for the kernels of all.
void beginStepOf(const Case& wanted) {
    const BodyState state = stateOf(wanted.mesh);
    GpuSolver solver;
    solver.setModel(buildBodyModel(wanted.mesh), state);
    solver.setUniforms(solverUniforms(wanted.params));
    solver.collisions().setSettings(contactSettings(wanted.params));
    solver.step();  // meets nothing
    solver.collisions().setBoxes({plate()});
    solver.collisions().setBlade(standingBlade());
    solver.collisions().feelBlade(true);
    solver.collisions().setEdge(pressingEdge());
    solver.setPulls(std::vector<shared::PullRecord>(1));
    RelativeMotion motion;
    motion.touching = true;
    motion.folded = wanted.folded;
    solver.collisions().expect(boundsOf(state.positions), boxOf({Vec3(0, -1, 0), Vec3(0, 1, 0)}),
                               motion);
    solver.step();
    ImplicitStep small;
    small.aggregateSize = kPatchSize;  // so many that large meshes have regions
    solver.stepImplicitly(buildBodyModel(wanted.mesh), wanted.params, small, {});
    solver.step();
    solver.stepBySweeps();
    solver.collisions().setBlade(std::nullopt);
    solver.collisions().setEdge(std::nullopt);
    for (const std::vector<StaticBox>& boxes : {std::vector{block()}, {}}) {
        solver.collisions().setBoxes(boxes);
        solver.step();
    }
    if (wanted.params.paperContact != 0) {
        solver.collisions().respondAsThePaper();
    }
}

/// Links every kernel that a simulation may need on the driver of the current context, as chosen by
/// gpu::kernelWay(), and dispatches most. Throws gpu::ShaderError, gpu::OutOfMemory.
void linkEveryKernel() {
    for (const bool folded : {true, false}) {
        beginStepOf({touchingBoxes(), paramsOf(SolverMode::implicit, false), folded});
    }
    beginStepOf({test::box(Vec3::Ones(), 20), paramsOf(SolverMode::implicit, false)});
    beginStepOf({touchingBoxes(), paramsOf(SolverMode::pbd, false)});
    beginStepOf({touchingBoxes(), paramsOf(SolverMode::pbd, true)});
}

/// During its lifetime no kernel runs, for which drivers compile it to the end.
class NoDispatches {
  public:
    NoDispatches() {
        glad_glDispatchCompute = [](auto...) {};
        glad_glDispatchComputeIndirect = [](GLintptr) {};
    }
    ~NoDispatches() {
        glad_glDispatchCompute = direct_;
        glad_glDispatchComputeIndirect = indirect_;
    }
    NoDispatches(const NoDispatches&) = delete;
    NoDispatches& operator=(const NoDispatches&) = delete;

  private:
    PFNGLDISPATCHCOMPUTEPROC direct_ = glad_glDispatchCompute;
    PFNGLDISPATCHCOMPUTEINDIRECTPROC indirect_ = glad_glDispatchComputeIndirect;
};

/// Links every program that Kerf can come to need, of both tiers of quality.
std::vector<gpu::LinkedProgram> everyProgram() {
    const gpu::ProgramRecord record;
    const NoDispatches none;
    linkEveryKernel();
    orderFindings({4});
    formFindings();
    for (const render::Quality quality : {render::Quality::light, render::Quality::full}) {
        render::Renderer(quality).linkEveryProgram();
    }
    return record.programs();
}

/// Texts of shaders, each once, with the file that it comes from.
using Texts = std::map<std::string, std::string>;

Texts textsOf(const std::vector<gpu::LinkedProgram>& programs) {
    Texts all;
    for (const gpu::LinkedProgram& program : programs) {
        for (const gpu::LinkedStage& stage : program.stages) {
            all.emplace(stage.text, stage.file);
        }
    }
    return all;
}

class EveryShader : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (programs().empty()) {
            for (const char* way : {"images", "shared"}) {
                const Variable kernels("KERF_KERNELS", way);
                std::ranges::copy(everyProgram(), std::back_inserter(programs()));
            }
        }
    }
    /// Of both ways; linked once for all tests.
    static std::vector<gpu::LinkedProgram>& programs() {
        static std::vector<gpu::LinkedProgram> linked;
        return linked;
    }
    static Texts texts() { return textsOf(programs()); }
};

TEST_F(EveryShader, IsAcceptedByTheReferenceCompiler) {
    const test::TemporaryFolder folder;
    std::string command = "glslangValidator";
    for (const auto& [text, file] : texts()) {
        std::string name =
            std::to_string(command.size()) + "-" + fs::path(file).filename().string();
        writeText(folder / name, text);
        command.append(" ").append((folder / name).string());
    }
    ASSERT_THAT(texts().size(), ::testing::Gt(300u));
    const std::string said = outputOf(command + " 2>&1");
    EXPECT_THAT(said.substr(0, 4000), Not(HasSubstr("ERROR")));
    EXPECT_THAT(said, Not(HasSubstr("failed")));
}

TEST_F(EveryShader, OfTheFoldersIsAmongThem) {
    std::set<std::string> linked;
    for (const auto& [text, file] : texts()) {
        linked.insert(file);
    }
    for (const auto& entry : fs::recursive_directory_iterator(gpu::shaderRoot())) {
        const std::string ending = entry.path().extension().string();
        if (ending == ".comp" || ending == ".vert" || ending == ".frag") {
            EXPECT_EQ(linked.count(fs::relative(entry.path(), gpu::shaderRoot()).string()), 1u)
                << entry.path();
        }
    }
}

/// All first groups of what is found.
std::set<std::string> namesIn(const std::string& text, const std::string& pattern) {
    const std::regex what(pattern);
    std::set<std::string> names;
    for (std::sregex_iterator at(text.begin(), text.end(), what), end; at != end; ++at) {
        names.insert((*at)[1]);
    }
    return names;
}

/// Parameters that are changed and arrays, alone or in a structure, and columns of matrices at a
/// computed place: NVIDIA's compilers took others (docs/notes/drivers.md).
std::set<std::string> mistakenForms(const std::string& text) {
    std::set<std::string> forms = namesIn(text, "\\b((?:in)?out \\w+ \\w+\\[)");
    forms.merge(namesIn(text, "\\b((?:in)?out mat\\d\\w* \\w+)"));
    for (const std::string& type : namesIn(text, "struct (\\w+) \\{[^}]*\\[[^}]*\\};")) {
        forms.merge(namesIn(text, "\\b((?:in)?out " + type + " )"));
    }
    for (const std::string& matrix : namesIn(text, "\\bmat\\d\\w* (\\w+)\\b")) {
        forms.merge(namesIn(text, "\\b(" + matrix + "\\[[^0-9])"));
    }
    return forms;
}

TEST_F(EveryShader, KeepsOffFormsThatCompilersMistake) {
    EXPECT_THAT(mistakenForms("void f(inout uint list[4]) {}\nmat4 m;\nvec4 c = m[i];"),
                ElementsAre("inout uint list[", "m[i"));
    for (const auto& [text, file] : texts()) {
        EXPECT_THAT(mistakenForms(text), IsEmpty()) << file;
    }
}

/// The words that decide what is compiled, of all shaders.
std::set<std::string> switchesIn(const fs::path& folder) {
    static const std::regex word("^#(?:ifdef|ifndef|if|elif)\\b(.*)$", std::regex::multiline);
    static const std::regex name("\\b[A-Z][A-Z_]+\\b");
    std::set<std::string> switches;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string text = entry.is_regular_file() ? readBytes(entry.path()) : "";
        for (std::sregex_iterator line(text.begin(), text.end(), word), end; line != end; ++line) {
            const std::string condition = (*line)[1];
            for (std::sregex_iterator at(condition.begin(), condition.end(), name); at != end;
                 ++at) {
                switches.insert(at->str());
            }
        }
    }
    std::erase_if(switches, [](const std::string& s) { return s.starts_with("KERF_"); });
    return switches;
}

TEST_F(EveryShader, IsThereWithEachSwitchOn) {
    std::set<std::string> inside{"BUMPS"};  // that shaders define themselves
    for (const std::string& each : switchesIn(gpu::shaderRoot())) {
        const auto has = [&](const gpu::LinkedProgram& program) {
            return std::ranges::count(program.defines, each, [](const auto& d) { return d.first; });
        };
        if (inside.count(each) == 0) {
            EXPECT_TRUE(std::ranges::any_of(programs(), has)) << each;
        }
    }
}

/// The value of a constant that is a number or another constant.
int constantIn(const std::string& text, const std::string& name) {
    std::smatch value;
    if (std::isdigit(static_cast<unsigned char>(name[0])) != 0) {
        return std::stoi(name);
    }
    if (!std::regex_search(text, value, std::regex("uint " + name + " = (\\w+)"))) {
        ADD_FAILURE() << name;
        return 0;
    }
    return constantIn(text, value[1]);
}

int countOf(const std::string& text, const std::regex& what) {
    return static_cast<int>(
        std::distance(std::sregex_iterator(text.begin(), text.end(), what), {}));
}

/// What kernels share in a work group, as they declare it [bytes].
int sharedBytes(const std::string& text) {
    static const std::regex declared("\\nshared (float|uint|vec2|vec3|vec4) \\w+\\[(\\w+)\\];");
    static const std::map<std::string, int> sizes{
        {"float", 4}, {"uint", 4}, {"vec2", 8}, {"vec3", 16}, {"vec4", 16}};
    int bytes = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), declared), end; at != end; ++at) {
        bytes += sizes.at((*at)[1]) * constantIn(text, (*at)[2]);
    }
    return bytes;
}

int threadsOf(const std::string& text) {
    std::smatch size;
    return std::regex_search(text, size, std::regex("local_size_x = (\\w+)"))
               ? constantIn(text, size[1])
               : 0;
}

/// Raises what is needed at most, by OpenGL's name of the limit, to what a text declares that the
/// reference compiler has preprocessed.
void raise(const std::string& file, const std::string& text,
           std::map<std::string, std::int64_t>& most) {
    static const std::regex buffer("\\bbuffer \\w+ *\\{");
    static const std::regex texture("\\buniform [iu]?sampler\\w+\\s+\\w+;");
    static const std::regex image("\\buniform [iu]?image\\w+\\s+\\w+;");
    const std::string ending = fs::path(file).extension();
    const std::string kind = ending == ".comp"   ? "COMPUTE"
                             : ending == ".vert" ? "VERTEX"
                                                 : "FRAGMENT";
    const auto to = [&](const std::string& limit, int needs) {
        most[limit] = std::max<std::int64_t>(most[limit], needs);
    };
    to("GL_MAX_" + kind + "_SHADER_STORAGE_BLOCKS", countOf(text, buffer));
    to(kind == "FRAGMENT" ? "GL_MAX_TEXTURE_IMAGE_UNITS"
                          : "GL_MAX_" + kind + "_TEXTURE_IMAGE_UNITS",
       countOf(text, texture));
    to("GL_MAX_" + kind + "_IMAGE_UNIFORMS", countOf(text, image));
    to("GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS", threadsOf(text));
    to("GL_MAX_COMPUTE_SHARED_MEMORY_SIZE", sharedBytes(text));
}

/// The most that any of these shaders needs. One process preprocesses them all.
std::map<std::string, std::int64_t> mostNeeded(const Texts& texts) {
    static const std::string kEnd = "#pragma kerf_end";
    const test::TemporaryFolder folder;
    std::string command = "glslangValidator -E";
    std::vector<std::string> files;
    for (const auto& [text, file] : texts) {
        const std::string ending = fs::path(file).extension();
        const fs::path copy = folder / (std::to_string(files.size()) + ending);
        writeText(copy, std::string(text).append("\n").append(kEnd).append("\n"));
        command.append(" ").append(copy.string());
        files.push_back(file);
    }
    const std::string all = outputOf(command);
    std::map<std::string, std::int64_t> most;
    std::size_t begin = 0;
    for (const std::string& file : files) {
        const std::size_t end = all.find(kEnd, begin);
        if (end == std::string::npos) {
            ADD_FAILURE() << file << " is missing";
            break;
        }
        raise(file, all.substr(begin, end - begin), most);
        begin = end + kEnd.size();
    }
    return most;
}

std::int64_t askedFor(const std::string& name) {
    for (const gpu::DriverLimit& limit : gpu::driverLimits()) {
        if (limit.name == name) {
            return limit.needs;
        }
    }
    return 0;
}

TEST_F(EveryShader, NeedsWhatKerfAsksOfADriver) {
    const Variable images("KERF_KERNELS", "images");
    for (const auto& [name, needs] : mostNeeded(texts())) {
        EXPECT_EQ(askedFor(name), needs) << name;
    }
    const Variable shared("KERF_KERNELS", "shared");
    EXPECT_EQ(askedFor("GL_MAX_COMPUTE_IMAGE_UNIFORMS"), 1) << "GPUs need one";
}

}  // namespace
}  // namespace kerf::app
