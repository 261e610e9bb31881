#include "app/files/import/builtin_models.h"

#include "app/files/io/errors.h"
#include "gpu/data_path.h"
#include "sim/base/text.h"

namespace kerf::app {

const std::vector<std::string>& builtinModels() {
    static const std::vector<std::string> names = {"sphere20", "sphere80", "sphere768", "banana",
                                                   "octopus"};
    return names;
}

std::filesystem::path builtinModelFile(const std::string& name) {
    if (std::ranges::find(builtinModels(), name) == builtinModels().end()) {
        throw InputError("there is no builtin model '" + name + "'; choose one of " +
                         joined(builtinModels(), ", "));
    }
    return gpu::dataPath("assets/models/" + name + ".obj");
}

}  // namespace kerf::app
