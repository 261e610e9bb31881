#pragma once

namespace kerf::test {

/// Files in one text, so that a folder can be changed like a file.
std::string packed(const std::vector<std::string>& files);
/// Writes the files of such a text into a folder under these names; what the text lacks is removed.
void unpack(const std::string& text, const std::filesystem::path& folder,
            const std::vector<std::string>& names);

}  // namespace kerf::test
