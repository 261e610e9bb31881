#include "sim/run/undo/undo_history.h"

#include <spdlog/fmt/fmt.h>

#include <ranges>

#include "sim/run/parts/snapshot.h"

namespace kerf {

namespace {

// See UndoHistory.SnapshotBytesAreAboutWhatTheHeapGives.
constexpr std::size_t kBytesPerVertex = 760;
constexpr std::size_t kBytesPerTriangle = 260;

// A number, and a node of a tree of places.
constexpr std::size_t kBytesPerPin = 84;

/// Of what a change holds apart from snapshots, which several may share.
struct OwnBytes {
    std::size_t operator()(const UndoEntry::ParamChange&) const { return 0; }
    std::size_t operator()(const UndoEntry::MaterialChange&) const { return 0; }
    std::size_t operator()(const UndoEntry::BodySnapshotChange&) const { return 0; }
    std::size_t operator()(const UndoEntry::PinChange& pins) const {
        return kBytesPerPin * (pins.before.count() + pins.after.count());
    }
    std::size_t operator()(const UndoEntry::BoxesChange& boxes) const {
        return sizeof(StaticBox) * (boxes.before.size() + boxes.after.size());
    }
};

void collect(const SnapshotPointer& snapshot, std::vector<const Snapshot*>& all) {
    if (snapshot && std::ranges::find(all, snapshot.get()) == all.end()) {
        all.push_back(snapshot.get());
    }
}

struct TextOf {
    std::string operator()(double number) const { return fmt::format("{:g}", number); }
    std::string operator()(const Vec3& v) const { return textOf(v); }
    std::string operator()(std::monostate) const { return "none"; }
    std::string operator()(std::string choice) const {
        std::ranges::replace(choice, '_', ' ');
        return choice;
    }
};

}  // namespace

std::size_t snapshotBytes(const SurfaceMesh& mesh) {
    return kBytesPerVertex * static_cast<std::size_t>(mesh.vertexCount()) +
           kBytesPerTriangle * static_cast<std::size_t>(mesh.triangleSlots());
}

std::string textOf(const Vec3& vector) {
    return fmt::format("({:g}, {:g}, {:g})", vector.x(), vector.y(), vector.z());
}

std::string nameOfChange(std::string_view param, const ParamValue& value) {
    const ParamInfo& info = *findParam(param);
    const int model = modelOf(param);
    const bool isSwitch = info.type == ParamType::integer && info.low == 0 && info.high == 1;
    const std::string whose = model > 0 ? fmt::format(" of model {}", model) : "";
    const std::string text =
        isSwitch ? (value == ParamValue(0.0) ? "off" : "on") : std::visit(TextOf{}, value);
    std::string name = fmt::format("{}{}: {}", info.label, whose, text);
    if (!info.unit.empty() && !std::holds_alternative<std::monostate>(value)) {
        name.append(" ").append(info.unit);
    }
    return name;
}

void UndoHistory::setBudget(std::size_t bytes) {
    budget_ = bytes;
    keepToBudget();
}

std::size_t UndoHistory::bytesFrom(std::size_t oldest) const {
    std::vector<const Snapshot*> all;
    std::size_t sum = 0;
    for (std::size_t i = oldest; i < entries_.size(); ++i) {
        sum += std::visit(OwnBytes{}, entries_[i].change);
        if (const auto* body = std::get_if<UndoEntry::BodySnapshotChange>(&entries_[i].change)) {
            collect(body->before, all);
            collect(body->after, all);
        }
    }
    for (const Snapshot* snapshot : all) {
        sum += snapshotBytes(snapshot->mesh);
    }
    return sum;
}

void UndoHistory::add(UndoEntry entry) {
    ++additions_;
    if (!keeps()) {
        return;
    }
    entries_.resize(done_);
    entries_.push_back(std::move(entry));
    ++done_;
    keepToBudget();
}

void UndoHistory::followCut(const SurfaceMesh& mesh, const CutDelta& delta) {
    const auto isOfBody = [](const UndoEntry& entry) {
        return std::holds_alternative<UndoEntry::BodySnapshotChange>(entry.change);
    };
    const auto now = entries_.begin() + static_cast<std::ptrdiff_t>(done_);
    const auto first = std::find_if(std::make_reverse_iterator(now), entries_.rend(), isOfBody);
    const auto end = std::find_if(now, entries_.end(), isOfBody);
    for (auto entry = first.base(); entry != end; ++entry) {
        if (auto* pins = std::get_if<UndoEntry::PinChange>(&entry->change)) {
            pins->before.follow(mesh, delta);
            pins->after.follow(mesh, delta);
        }
    }
    keepToBudget();
}

void UndoHistory::forgetAll() {
    ++additions_;
    forgotten_ += static_cast<int>(done_) + 1;
    entries_.clear();
    done_ = 0;
}

void UndoHistory::clear() {
    ++additions_;
    entries_.clear();
    done_ = 0;
    forgotten_ = 0;
}

void UndoHistory::markUndone(SnapshotPointer after) {
    --done_;
    if (auto* body = std::get_if<UndoEntry::BodySnapshotChange>(&entries_[done_].change)) {
        body->after = std::move(after);
    }
    keepToBudget();
}

void UndoHistory::markRedone() {
    if (auto* body = std::get_if<UndoEntry::BodySnapshotChange>(&entries_[done_].change)) {
        body->after.reset();
    }
    ++done_;
}

/// A change can only be taken back after all later ones, so the oldest are forgotten first. What is
/// undone can only be brought back from the oldest on, so there the latest would go; all of it
/// does.
void UndoHistory::keepToBudget() {
    std::size_t oldest = 0;
    while (oldest < done_ && bytesFrom(oldest) > budget_) {
        ++oldest;
    }
    entries_.erase(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(oldest));
    done_ -= oldest;
    forgotten_ += static_cast<int>(oldest);
    if (bytes() > budget_) {
        entries_.clear();
    }
}

}  // namespace kerf
