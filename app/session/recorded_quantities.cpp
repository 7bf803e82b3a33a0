// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/recorded_quantities.h"

#include <string_view>

namespace chiron::session {

namespace {
constexpr std::string_view kPrefix = "quantity.";
constexpr std::size_t kSupplied = core::kMaxQuantities; // slots beyond the array of the header
constexpr std::size_t kStored = core::kMaxQuantities + 1;
} // namespace

RecordedQuantities::RecordedQuantities(const recording::ChannelTable& table) {
    for (const recording::Channel& channel : table.channels()) {
        if (channel.tool != recording::kNoTool)
            continue;
        if (channel.id.starts_with(kPrefix) && channel.slot < core::kMaxQuantities)
            m_list.push_back({channel.id.substr(kPrefix.size()), channel.unit, channel.slot});
        else if (channel.id == "energy.supplied")
            m_list.push_back({"energy_supplied_J", "J", kSupplied});
        else if (channel.id == "energy.stored")
            m_list.push_back({"energy_stored_J", "J", kStored});
    }
}

double RecordedQuantities::value(std::size_t i, const core::HapticFrame& frame) const noexcept {
    const std::size_t slot = m_list[i].slot;
    return slot == kSupplied ? frame.header.energySupplied_J
           : slot == kStored ? frame.header.energyStored_J
                             : frame.header.quantities[slot];
}

std::vector<scoring::QuantityTrace> RecordedQuantities::emptyColumns() const {
    std::vector<scoring::QuantityTrace> columns;
    for (const Quantity& quantity : m_list)
        columns.push_back({quantity.id, {}});
    return columns;
}

} // namespace chiron::session
