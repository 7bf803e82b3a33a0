// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "recording/channel_table.h"
#include "scoring/trace.h"

#include <cstddef>
#include <string>
#include <vector>

namespace chiron::session {

/// The scene's quantities of a recording, according to its own channel table and in that order: "tension_N",
/// … and the energy balance as "energy_supplied_J" and "energy_stored_J". Immutable after construction.
/// Thread: any.
class RecordedQuantities {
public:
    struct Quantity {
        std::string id;   ///< with its unit, as named by the exercise
        std::string unit; ///< SI
        std::size_t slot = 0;
    };

    RecordedQuantities() = default; ///< empty
    explicit RecordedQuantities(const recording::ChannelTable& table);

    const std::vector<Quantity>& list() const noexcept { return m_list; }
    std::size_t size() const noexcept { return m_list.size(); }
    /// The stored value in SI. Requires `i` < size().
    double value(std::size_t i, const core::HapticFrame& frame) const noexcept;
    /// One empty column per quantity.
    std::vector<scoring::QuantityTrace> emptyColumns() const;

private:
    std::vector<Quantity> m_list;
};

} // namespace chiron::session
