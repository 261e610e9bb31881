#pragma once

#include <nlohmann/json.hpp>
#include <type_traits>

#include "app/files/io/errors.h"

namespace kerf::app {

/// A glTF 2.0 file, as JSON or as GLB, with its buffers. Nothing in it is trusted: all functions
/// throw InputError for missing or invalid data.
class GltfFile {
  public:
    using Json = nlohmann::json;

    /// Reads the description, without buffers.
    explicit GltfFile(const std::filesystem::path& file);
    /// Opens the buffers; call it before reading numbers.
    void openBuffers();

    /// The whole description.
    const Json& top() const { return top_; }
    /// The item of a list at the top: item("meshes", 3).
    const Json& item(const char* list, std::uint64_t index) const;
    /// The numbers of an accessor, `width` for each of its items; normalized ones as shares.
    std::vector<double> numbers(std::uint64_t accessor, std::size_t width) const;
    /// The bytes of a bufferView.
    std::string_view view(std::uint64_t index) const;
    /// The bytes behind a URI: those in a data URI, or those of a file beside this one.
    std::string bytesOf(const std::string& uri) const;

  private:
    void addNumbers(const Json& from, const Json& type, std::size_t width, std::uint64_t count,
                    std::vector<double>& numbers) const;
    void replaceSparse(const Json& accessor, std::size_t width, std::vector<double>& numbers) const;

    std::filesystem::path file_;
    Json top_;
    std::string binary_;  ///< of a GLB
    std::vector<std::string> buffers_;
};

/// The value of a key; `otherwise` if missing. Throws InputError for another type.
template <class T>
T valueOf(const nlohmann::json& object, const char* key, T otherwise) {
    const auto found = object.find(key);
    if (found == object.end()) {
        return otherwise;
    }
    try {
        if (std::is_unsigned_v<T> && found->is_number() && found->template get<double>() < 0) {
            throw InputError("its \"" + std::string(key) + "\" is negative");
        }
        if (std::is_integral_v<T> && found->is_number_float() &&
            found->template get<double>() != std::floor(found->template get<double>())) {
            throw InputError("its \"" + std::string(key) + "\" is no whole number");
        }
        return found->template get<T>();
    } catch (const nlohmann::json::exception&) {
        throw InputError("its \"" + std::string(key) + "\" is not what glTF has there");
    }
}

/// A URI without its escapes, such as %20.
std::string unescaped(std::string_view uri);

}  // namespace kerf::app
