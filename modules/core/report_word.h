// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"

#include <cstdint>

namespace chiron::core {

/// What a person says about what the fingers found. Numbers are part of the recording's format.
enum class ReportField : std::uint8_t {
    found = 0,      ///< a new finding at the tool's place: the mark, no report word
    size = 1,       ///< value: radius in 0.1 mm; 0: not said
    hardness = 2,   ///< value: 1 (soft) .. 5 (stony); 0: not said
    confidence = 3, ///< value: 1 (a guess) .. 5 (certain); 0: not said
    remove = 4,     ///< take the finding back; value: its number from 0
    select = 5,     ///< further words are about this finding; value: its number from 0
    done = 6,       ///< nothing more to report: ends the trial
};

/// One report as it travels: the argument of CommandKind::report, and the upper 16 bits of a tool's buttons while
/// kButtonReport is pressed (a device with a keypad, a scripted hand, a trace file). Field in the upper 4 bits.
inline constexpr std::uint16_t kReportValueMask = 0x0fff;
constexpr std::uint16_t reportWord(ReportField field, unsigned value) noexcept {
    return static_cast<std::uint16_t>((static_cast<unsigned>(field) << 12) | (value & kReportValueMask));
}
constexpr ReportField reportField(std::uint16_t word) noexcept { return static_cast<ReportField>(word >> 12); }
constexpr unsigned reportValue(std::uint16_t word) noexcept { return word & kReportValueMask; }
/// Buttons that say `word`: an edge of kButtonReport takes it.
constexpr std::uint32_t reportButtons(std::uint16_t word) noexcept {
    return kButtonReport | (static_cast<std::uint32_t>(word) << 16);
}

} // namespace chiron::core
