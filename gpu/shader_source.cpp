#include "gpu/shader_source.h"

#include <spdlog/fmt/fmt.h>

#include <fstream>
#include <regex>
#include <sstream>

namespace kerf::gpu {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kVersion = "#version 450 core";

// #line directives carry file * kLinesPerFile + line. The source-string number would be the proper
// place for the file, but Mesa forgets it for every location that its grammar derives.
constexpr std::size_t kLinesPerFile = 100000;

std::string lineDirective(std::size_t file, std::size_t line) {
    return fmt::format("#line {}\n", file * kLinesPerFile + line);
}

std::optional<std::string> readFile(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        return std::nullopt;
    }
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

std::string displayName(const fs::path& root, const fs::path& path) {
    const fs::path relative = path.lexically_relative(root.parent_path());
    const bool outside = relative.empty() || *relative.begin() == "..";
    return (outside ? path : relative).generic_string();
}

/// The word behind '#' of a directive line, and what follows it; empty for any other line.
struct Directive {
    std::string word;
    std::string rest;
};

Directive parseDirective(const std::string& line) {
    static const std::regex kDirective(R"(^\s*#\s*(\w+)\s*(.*?)\s*$)");
    std::smatch match;
    if (!std::regex_match(line, match, kDirective)) {
        return {};
    }
    return {match[1], match[2]};
}

/// The name between quotes; nothing for <x>, which only C++ reads.
std::optional<std::string> quotedName(const std::string& text) {
    static const std::regex kQuoted("^\"([^\"]+)\".*");
    std::smatch match;
    if (!std::regex_match(text, match, kQuoted)) {
        return std::nullopt;
    }
    return match[1];
}

/// The files beside `pattern` with its extension, by name.
std::vector<fs::path> filesLike(const fs::path& pattern) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(pattern.parent_path())) {
        if (entry.path().extension() == pattern.extension()) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

class Expander {
  public:
    explicit Expander(fs::path root) : root_(std::move(root)) {}

    ShaderSource expand(const std::string& path, const Defines& defines) {
        const fs::path file = (root_ / path).lexically_normal();
        const std::optional<std::string> content = readFile(file);
        if (!content) {
            throw ShaderError("The shader " + file.string() + " cannot be read.");
        }
        out_ << kVersion << '\n';
        for (const auto& [name, value] : defines) {
            out_ << "#define " << name << ' ' << value << '\n';
        }
        append(file, *content);
        return {out_.str(), std::move(files_)};
    }

  private:
    void append(const fs::path& file, const std::string& content) {
        const std::size_t index = fileIndex(file);
        stack_.push_back(file);
        out_ << "// file " << files_[index] << '\n' << lineDirective(index, 1);
        std::istringstream in(content);
        std::string line;
        for (std::size_t number = 1; std::getline(in, line); ++number) {
            appendLine(line, number, index);
        }
        stack_.pop_back();
    }

    void appendLine(const std::string& line, std::size_t number, std::size_t index) {
        const Directive directive = parseDirective(line);
        if (directive.word == "include") {
            include(directive.rest, number, index);
        } else if (directive.word == "pragma" && directive.rest == "once") {
            once_.insert(stack_.back());
            out_ << '\n';
        } else if (directive.word == "version") {
            out_ << '\n';  // ours stands in front
        } else {
            out_ << line << '\n';
            // What an #include says of its line is not read where it is switched off.
            if (directive.word == "endif" || directive.word == "else" || directive.word == "elif") {
                out_ << lineDirective(index, number + 1);
            }
        }
    }

    void include(const std::string& argument, std::size_t number, std::size_t index) {
        const std::optional<std::string> name = quotedName(argument);
        if (!name) {
            out_ << "#error #include needs a name in quotes\n";
            return;
        }
        const std::string place = fmt::format("{}:{}: ", files_[index], number);
        const std::vector<fs::path> files = find(*name);
        if (files.empty()) {
            throw ShaderError(place + "the file \"" + *name + "\" to include was not found");
        }
        for (const fs::path& file : files) {
            if (std::find(stack_.begin(), stack_.end(), file) != stack_.end()) {
                throw ShaderError(place + "\"" + *name + "\" includes itself");
            }
            if (!once_.contains(file)) {
                append(file, readFile(file).value_or(""));
            }
        }
        out_ << lineDirective(index, number + 1);
    }

    /// The file of a name, or those of "folder/*.glsl".
    std::vector<fs::path> find(const std::string& name) const {
        const std::array<fs::path, 3> folders = {stack_.back().parent_path(), root_,
                                                 root_ / "shared"};
        for (const fs::path& folder : folders) {
            const fs::path file = (folder / name).lexically_normal();
            if (file.stem() == "*" && fs::is_directory(file.parent_path())) {
                return filesLike(file);
            }
            if (fs::is_regular_file(file)) {
                return {file};
            }
        }
        return {};
    }

    std::size_t fileIndex(const fs::path& file) {
        const std::string name = displayName(root_, file);
        const auto found = std::find(files_.begin(), files_.end(), name);
        const auto index = static_cast<std::size_t>(found - files_.begin());
        if (found == files_.end()) {
            files_.push_back(name);
        }
        return index;
    }

    fs::path root_;
    std::ostringstream out_;
    std::vector<std::string> files_;
    std::vector<fs::path> stack_;
    std::set<fs::path> once_;
};

std::string explainLine(const std::string& line, const std::vector<std::string>& files) {
    static const std::array<std::regex, 3> kForms = {
        std::regex(R"(^\d+:(\d+)\(\d+\):\s*(.*)$)"), std::regex(R"(^\d+\((\d+)\)\s*:\s*(.*)$)"),
        std::regex(R"(^(?:ERROR|WARNING):\s*\d+:(\d+):\s*(.*)$)")};
    std::smatch match;
    for (const std::regex& form : kForms) {
        if (std::regex_match(line, match, form)) {
            const std::size_t code = std::stoul(match[1]);
            const std::size_t file = code / kLinesPerFile;
            const std::string name = file < files.size() ? files[file] : "?";
            return fmt::format("{}:{}: {}", name, code % kLinesPerFile, match[2].str());
        }
    }
    return line;
}

}  // namespace

ShaderSource loadShaderSource(const fs::path& root, const std::string& path,
                              const Defines& defines) {
    return Expander(root).expand(path, defines);
}

std::string explainLog(std::string_view log, const std::vector<std::string>& files) {
    std::istringstream in{std::string(log)};
    std::string out;
    std::string line;
    while (std::getline(in, line)) {
        out += (out.empty() ? "" : "\n") + explainLine(line, files);
    }
    return out;
}

}  // namespace kerf::gpu
