#include "app/session/session_json.h"

#include <cctype>

#include "app/files/io/errors.h"

namespace kerf::app {

namespace {

std::string lineAndColumn(std::string_view text, std::size_t position) {
    const std::string_view before = text.substr(0, std::min(position, text.size()));
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t lineStart = lines == 0 ? 0 : before.rfind('\n') + 1;
    return "line " + std::to_string(lines + 1) + ", column " +
           std::to_string(std::max<std::size_t>(before.size() - lineStart, 1));
}

/// What the parser stumbled over, short and printable.
std::string excerpt(std::string token) {
    const auto unprintable = [](unsigned char c) { return std::iscntrl(c) != 0 || c > 126; };
    std::replace_if(token.begin(), token.end(), unprintable, '?');
    constexpr std::size_t longest = 24;
    return token.size() <= longest ? token : token.substr(token.size() - longest);
}

/// Builds the document while it is read, and stops at what must not be kept.
template <class Json>
class DocumentBuilder : public nlohmann::json_sax<Json> {
    using Sax = nlohmann::json_sax<Json>;

  public:
    explicit DocumentBuilder(std::string_view text) : text_(text) {}
    Json take() { return std::move(root_); }

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(typename Sax::number_integer_t value) override { return put(value); }
    bool number_unsigned(typename Sax::number_unsigned_t value) override { return put(value); }
    bool number_float(typename Sax::number_float_t value, const typename Sax::string_t&) override {
        return put(value);
    }
    bool string(typename Sax::string_t& value) override { return put(std::move(value)); }
    bool binary(typename Sax::binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(typename Sax::string_t& name) override {
        if (open_.back()->contains(name)) {
            throw InputError(place() + ": the key '" + excerpt(name) +
                             "' stands there twice; keep one.");
        }
        keys_.back() = name;
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::detail::exception& error) override {
        // out_of_range 406 is the only other error of this parser: a number such as 1e999.
        const bool overflow = error.id == 406;
        throw InputError(lineAndColumn(text_, position) + ": " +
                         (overflow ? "the number '" + excerpt(token) + "' is too large."
                          : token.empty()
                              ? "the text ends too early."
                              : "this is not valid JSON near '" + excerpt(token) + "'."));
    }

  private:
    bool put(Json value) {
        insert(std::move(value));
        return true;
    }

    Json* insert(Json value) {
        if (open_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        Json& parent = *open_.back();
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        Json& slot = parent[keys_.back()];
        slot = std::move(value);
        return &slot;
    }

    bool open(Json container) {
        if (open_.size() >= kMaxJsonDepth) {
            const std::string key = keys_.front().empty() ? "" : excerpt(keys_.front()) + ": ";
            throw InputError(key + "nested deeper than " + std::to_string(kMaxJsonDepth) +
                             " levels.");
        }
        open_.push_back(insert(std::move(container)));
        keys_.emplace_back();
        return true;
    }

    bool close() {
        open_.pop_back();
        keys_.pop_back();
        return true;
    }

    /// Where the container that is open now stands: "events[3]"; of a long way there, the end.
    std::string place() const {
        constexpr std::size_t longest = 120;
        std::string text;
        for (std::size_t level = 0; level + 1 < open_.size(); ++level) {
            if (open_[level]->is_array()) {
                text += "[" + std::to_string(open_[level]->size() - 1) + "]";
            } else {
                text += (text.empty() ? "" : ".") + excerpt(keys_[level]);
            }
        }
        if (text.size() > longest) {
            return "..." + text.substr(text.size() - longest);
        }
        return text.empty() ? "top level" : text;
    }

    std::string_view text_;
    Json root_;
    std::vector<Json*> open_;
    std::vector<std::string> keys_;  ///< the key being filled at each open level
};

// The parser takes a zero byte for the end of the text.
template <class Json>
Json parse(std::string_view text) {
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        throw InputError(lineAndColumn(text, zero) + ": a zero byte is not valid JSON.");
    }
    DocumentBuilder<Json> builder(text);
    // Every error throws out of the builder, so the result needs no look.
    Json::sax_parse(text, &builder);
    return builder.take();
}

}  // namespace

nlohmann::json parseJson(std::string_view text) {
    return parse<nlohmann::json>(text);
}

nlohmann::ordered_json parseOrderedJson(std::string_view text) {
    return parse<nlohmann::ordered_json>(text);
}

}  // namespace kerf::app
