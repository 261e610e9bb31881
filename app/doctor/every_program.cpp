#include "app/doctor/every_program.h"

#include "render/renderer.h"
#include "sim/run/start/every_kernel.h"

namespace kerf::app {

std::vector<gpu::LinkedProgram> everyProgram() {
    const gpu::ProgramRecord record;
    linkEveryKernel();
    for (const render::Quality quality : {render::Quality::light, render::Quality::full}) {
        render::Renderer(quality).linkEveryProgram();
    }
    return record.programs();
}

}  // namespace kerf::app
