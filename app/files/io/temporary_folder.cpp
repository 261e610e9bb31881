#include "app/files/io/temporary_folder.h"

#include <stdlib.h>

#include <system_error>

#include "app/files/io/file_io.h"

namespace kerf::app {

TemporaryFolder::TemporaryFolder(const std::string& name) {
    std::error_code error;
    std::string path = (std::filesystem::temp_directory_path(error) / (name + "-XXXXXX")).string();
    if (error || ::mkdtemp(path.data()) == nullptr) {
        throw OutputError("No temporary folder could be made; set TMPDIR to one that exists.");
    }
    path_ = path;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
}

}  // namespace kerf::app
