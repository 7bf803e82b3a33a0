// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::core {

/// What a scene says of one tool's contact beside its force, at one tick (simulation::SceneOutput::contact). Recorded in the upper
/// bits of ToolFrame::status; numbers are part of the recording's format. Source: data.md, Range of a law.
namespace contact_bits {
inline constexpr std::uint8_t kBeyondChecked = 1u << 0; ///< outside the poses and depths for which the law was checked; its force is bounded
inline constexpr std::uint8_t kYielded = 1u << 1;       ///< at this tick the tissue gave way
inline constexpr std::uint8_t kThrough = 1u << 2;       ///< it has given way: on its falling curve, or through, until the tool is out again
inline constexpr std::uint8_t kAll = kBeyondChecked | kYielded | kThrough;
} // namespace contact_bits

/// Where the bits of contact stand in ToolFrame::status.
inline constexpr int kContactStatusShift = 28;
inline constexpr std::uint32_t kContactStatusMask = std::uint32_t{contact_bits::kAll} << kContactStatusShift;

constexpr std::uint32_t contactStatus(std::uint8_t contact) noexcept {
    return (std::uint32_t{contact} & contact_bits::kAll) << kContactStatusShift;
}
constexpr std::uint8_t contactOfStatus(std::uint32_t status) noexcept {
    return static_cast<std::uint8_t>((status & kContactStatusMask) >> kContactStatusShift);
}

} // namespace chiron::core
