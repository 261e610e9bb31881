#include "app/editor/storage/manual.h"

#include <sys/wait.h>

#include <cstdlib>
#include <regex>

#include "app/files/io/errors.h"
#include "gpu/data_path.h"

namespace kerf::app {

std::filesystem::path manualPage() {
    const std::filesystem::path installed =
        gpu::programFolder().parent_path() / "share/doc/kerf/html/index.html";
    for (const std::filesystem::path& page : {installed, gpu::dataPath("out/docs/index.html")}) {
        if (std::filesystem::exists(page)) {
            return page;
        }
    }
    return gpu::dataPath("docs/index.md");
}

std::string openOutside(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) {
        throw OutputError("The manual is not installed: there is no " + file.string() + ".");
    }
    // It may become the browser and not end, which is no failure.
    const std::string quoted =
        "'" + std::regex_replace(file.string(), std::regex("'"), "'\\''") + "'";
    const int status =
        std::system(("command -v xdg-open >/dev/null || exit 127; xdg-open " + quoted +
                     " >/dev/null 2>&1 & for i in 1 2 3 4 5 6; do sleep 0.5; "
                     "kill -0 $! 2>/dev/null || { wait $!; exit; }; done")
                        .c_str());
    if (status != 0) {
        const bool missing = WIFEXITED(status) && WEXITSTATUS(status) == 127;
        throw OutputError("The manual is " + file.string() + ", but " +
                          (missing ? "xdg-open, which would show it, is not installed."
                                   : "no program was found to show it."));
    }
    return "Opened " + file.string();
}

}  // namespace kerf::app
