#include "app/files/temporary_folder.h"

#include <stdlib.h>

#include <system_error>

#include "app/files/file_io.h"

namespace kerf::app {

TemporaryFolder::TemporaryFolder(const std::string& name) {
    std::string path = (std::filesystem::temp_directory_path() / (name + "-XXXXXX")).string();
    if (::mkdtemp(path.data()) == nullptr) {
        throw OutputError(path + ": no temporary folder could be made; set TMPDIR.");
    }
    path_ = path;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
}

}  // namespace kerf::app
