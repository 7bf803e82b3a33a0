// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::simulation {

/// A part of a person's report about a finding. The numbers are part of the recording's format.
enum class ReportField : std::uint8_t {
    found = 0,      ///< a new finding at the tool's position; sent by the mark itself, not by a report word
    size = 1,       ///< value: radius in 0.1 mm; 0: not stated
    hardness = 2,   ///< value: 1 (soft) .. 5 (stony); 0: not stated
    confidence = 3, ///< value: 1 (a guess) .. 5 (certain); 0: not stated
    remove = 4,     ///< withdraw the finding; value: its number from 0
    select = 5,     ///< the following words are about this finding; value: its number from 0
    done = 6,       ///< nothing more to report: ends the trial
};

/// Encoding of one report: the argument of core::CommandKind::report and the word of core::kButtonReport. The
/// field is in the upper 4 bits.
inline constexpr std::uint16_t kReportValueMask = 0x0fff;
constexpr std::uint16_t reportWord(ReportField field, unsigned value) noexcept {
    return static_cast<std::uint16_t>((static_cast<unsigned>(field) << 12) | (value & kReportValueMask));
}
constexpr ReportField reportField(std::uint16_t word) noexcept {
    return static_cast<ReportField>(word >> 12);
}
constexpr unsigned reportValue(std::uint16_t word) noexcept {
    return word & kReportValueMask;
}

} // namespace chiron::simulation
