#pragma once

namespace kerf::app {

/// Files by key in a folder of their own, which may be deleted at any time. Beyond a budget those
/// that were used longest ago are removed. Damaged ones are not found.
class FileCache {
  public:
    /// `budget` [bytes]. An empty path keeps nothing.
    explicit FileCache(std::filesystem::path folder, std::uintmax_t budget = kBudget)
        : folder_(std::move(folder)), budget_(budget) {}

    /// Keeps bytes under a key, a file name.
    void keep(const std::string& key, const std::vector<std::byte>& bytes) const;
    std::optional<std::vector<std::byte>> find(const std::string& key) const;

  private:
    static constexpr std::uintmax_t kBudget = 2'000'000'000;  // [bytes]
    void keepToBudget() const;

    std::filesystem::path folder_;
    std::uintmax_t budget_;
};

}  // namespace kerf::app
