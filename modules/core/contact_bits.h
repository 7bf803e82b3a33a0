// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::core {

/// Flags that a scene reports about one tool's contact in addition to its force, at one tick
/// (simulation::SceneOutput::contact). They are recorded in the upper bits of ToolFrame::status; their
/// numbers are part of the recording's format. Source: data.md, Range of a law.
namespace contact_bits {
/// Outside the poses and depths for which the law was checked; the force is bounded.
inline constexpr std::uint8_t kBeyondChecked = 1u << 0;
/// The tissue gave way at this tick.
inline constexpr std::uint8_t kYielded = 1u << 1;
/// The tissue has given way: its force is falling or gone, until the tool is outside again.
inline constexpr std::uint8_t kThrough = 1u << 2;
inline constexpr std::uint8_t kAll = kBeyondChecked | kYielded | kThrough;
} // namespace contact_bits

/// Position of the contact bits in ToolFrame::status.
inline constexpr int kContactStatusShift = 28;
inline constexpr std::uint32_t kContactStatusMask = std::uint32_t{contact_bits::kAll} << kContactStatusShift;

constexpr std::uint32_t contactStatus(std::uint8_t contact) noexcept {
    return (std::uint32_t{contact} & contact_bits::kAll) << kContactStatusShift;
}
constexpr std::uint8_t contactOfStatus(std::uint32_t status) noexcept {
    return static_cast<std::uint8_t>((status & kContactStatusMask) >> kContactStatusShift);
}

} // namespace chiron::core
