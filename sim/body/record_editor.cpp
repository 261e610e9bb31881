#include "sim/body/record_editor.h"

#include <cassert>

namespace kerf {

IncidenceRooms::IncidenceRooms(const Incidence& incidence) {
    room_.reserve(incidence.ranges.size());
    for (const IncidenceRange& range : incidence.ranges) {
        room_.push_back(incidenceRoom(range.end - range.first));
    }
}

void IncidenceRooms::resize(Incidence& incidence, std::size_t vertexCount) {
    incidence.ranges.resize(vertexCount);
    room_.resize(vertexCount, 0);
}

void IncidenceRooms::add(Incidence& incidence, std::uint32_t vertex, std::uint32_t entry) {
    if (valence(incidence, vertex) == room_[vertex]) {
        grow(incidence, vertex, room_[vertex] + 1);
    }
    IncidenceRange& range = incidence.ranges[vertex];
    const auto begin = incidence.entries.begin() + range.first;
    const auto end = incidence.entries.begin() + range.end;
    const auto place = std::lower_bound(begin, end, entry);
    std::copy_backward(place, end, end + 1);
    *place = entry;
    ++range.end;
}

void IncidenceRooms::remove(Incidence& incidence, std::uint32_t vertex, std::uint32_t entry) {
    IncidenceRange& range = incidence.ranges[vertex];
    const auto begin = incidence.entries.begin() + range.first;
    const auto end = incidence.entries.begin() + range.end;
    const auto place = std::lower_bound(begin, end, entry);
    assert(place != end && *place == entry);
    std::copy(place + 1, end, place);
    --range.end;
}

void IncidenceRooms::assign(Incidence& incidence, std::uint32_t vertex,
                            std::span<const std::uint32_t> entries) {
    const auto size = static_cast<std::uint32_t>(entries.size());
    if (size > room_[vertex]) {
        grow(incidence, vertex, size);
    }
    IncidenceRange& range = incidence.ranges[vertex];
    std::copy(entries.begin(), entries.end(), incidence.entries.begin() + range.first);
    range.end = range.first + size;
}

void IncidenceRooms::grow(Incidence& incidence, std::uint32_t vertex, std::uint32_t least) {
    const std::uint32_t room = room_[vertex];
    const std::uint32_t wider = std::max(incidenceRoom(room + room / 2 + 1), incidenceRoom(least));
    const std::uint32_t first = takeBlock(incidence, wider);
    IncidenceRange& range = incidence.ranges[vertex];
    std::copy(incidence.entries.begin() + range.first, incidence.entries.begin() + range.end,
              incidence.entries.begin() + first);
    if (room > 0) {
        idleBlocks(room).push_back(range.first);
    }
    range = {first, first + (range.end - range.first)};
    room_[vertex] = wider;
}

std::uint32_t IncidenceRooms::takeBlock(Incidence& incidence, std::uint32_t room) {
    std::vector<std::uint32_t>& idle = idleBlocks(room);
    if (!idle.empty()) {
        const std::uint32_t first = idle.back();
        idle.pop_back();
        return first;
    }
    const auto first = static_cast<std::uint32_t>(incidence.entries.size());
    incidence.entries.resize(first + room);
    return first;
}

std::vector<std::uint32_t>& IncidenceRooms::idleBlocks(std::uint32_t room) {
    const std::size_t size = room / 4;
    if (size >= idle_.size()) {
        idle_.resize(size + 1);
    }
    return idle_[size];
}

}  // namespace kerf
