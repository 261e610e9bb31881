#include "app/files/io/errors.h"
#include "app/link/igtl_message.h"
#include "tests/support/fuzz/refusal.h"
#include "tests/support/fuzz/targets.h"

namespace kerf::test {

namespace {

using app::IgtlMessage;

/// A QTDATA of one tool, which lies along x.
std::string toolOf(const std::string& name) {
    std::string content = name;
    content.resize(22, '\0');
    return content + std::string(12, '\0') + std::string("\0\0\0\0\x3f\x35\x04\xf3\0\0\0\0", 12) +
           std::string("\x3f\x35\x04\xf3", 4);
}

/// The same message with a header of version 2 and metadata.
std::string extended(const IgtlMessage& message) {
    IgtlMessage longer = message;
    longer.content =
        std::string("\0\x0c\0\2\0\0\0\0\0\0\0\1", 12) + message.content + std::string("\0\0", 2);
    std::string bytes = app::packIgtl(longer);
    bytes[1] = 2;
    return bytes;
}

std::vector<IgtlMessage> messages() {
    const std::string pose = app::transformOf({{1, 2, 3}, Vec3::UnitX()});
    return {{"TRANSFORM", "Blade", pose},
            {"POSITION", "Blade", toolOf("").substr(22)},
            {"QTDATA", "Tracker", toolOf("Other") + toolOf("Blade")},
            {"STRING", "Blade", app::stringOf("lift")},
            {"IMAGE", "Scan", "pixels"}};
}

/// What is said of a message that came must be what is said of it once it was sent on.
std::string brokenBy(const IgtlMessage& message) {
    app::IgtlReader reader;
    reader.add(app::packIgtl(message));
    const auto again = reader.next();
    if (!again || again->type != message.type || again->device != message.device ||
        again->content != message.content) {
        return "It reads back otherwise.";
    }
    const auto pose = app::poseIn(message, "Blade");
    if (pose && !(pose->position.allFinite() && std::abs(pose->zAxis.norm() - 1) < 1e-12)) {
        return "It is no pose.";
    }
    const auto text = app::textIn(message);
    return text && app::stringOf(*text).size() != message.content.size() ? "It is no text." : "";
}

/// With the checksums that bodies have, or hardly anything would be read.
std::string mended(std::string bytes) {
    constexpr std::size_t kHeader = 58;
    for (std::size_t at = 0; at + kHeader <= bytes.size();) {
        std::uint64_t size = 0;
        for (std::size_t i = 42; i < 50; ++i) {
            size = size << 8 | static_cast<unsigned char>(bytes[at + i]);
        }
        if (size > bytes.size() - at - kHeader) {
            break;
        }
        const std::string body = bytes.substr(at + kHeader, size);
        bytes.replace(at + 50, 8, app::packIgtl({"", "", body}), 50, 8);
        at += kHeader + size;
    }
    return bytes;
}

FuzzOutcome readStream(const std::string& bytes) {
    FuzzOutcome outcome;
    app::IgtlReader reader;
    try {
        for (std::size_t at = 0; at < bytes.size(); at += 61) {  // as a network may divide them
            reader.add(std::string_view(bytes).substr(at, 61));
            while (const auto message = reader.next()) {
                outcome.accepted = true;
                outcome.broken += brokenBy(*message);
            }
        }
    } catch (const app::InputError& error) {
        outcome.broken += refusedWith(error.what()).broken;
    }
    return outcome;
}

}  // namespace

FuzzOutcome readLinkBytes(const std::string& bytes) {
    FuzzOutcome outcome = readStream(mended(bytes));
    outcome.broken += readStream(bytes).broken;
    return outcome;
}

std::vector<std::string> linkTexts() {
    std::vector<std::string> texts{"", extended(messages().front())};
    std::string all;
    for (const IgtlMessage& message : messages()) {
        texts.push_back(app::packIgtl(message));
        all += texts.back();
    }
    texts.push_back(all);
    return texts;
}

std::vector<std::string> linkWords() {
    std::vector<std::string> words = linkTexts();  // whole messages too, as their checksums hold
    for (const char* word : {"TRANSFORM", "POSITION", "QTDATA", "STRING", "Blade", "lift"}) {
        words.emplace_back(word);
    }
    words.emplace_back("\x7f\xc0\0\0", 4);  // no number
    words.emplace_back("\x7f\x80\0\0", 4);
    return words;
}

}  // namespace kerf::test
