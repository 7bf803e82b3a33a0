// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::core {

/// The stimulus that a study asks the scene to present, packed into the 16 bits of a command's argument, so
/// that a recording and its replay contain every stimulus exactly. It states the candidate of the study's
/// frozen table and how the candidate's multiples are assigned to the positions
/// (psychophysics/study/arrangement.h).
struct PresentationWord {
    static constexpr int kCandidates = 4096;
    static constexpr int kArrangements = 16;

    int candidate = 0;   ///< 0..kCandidates-1: row of the table of levels
    int arrangement = 0; ///< 0..kArrangements-1

    friend bool operator==(const PresentationWord&, const PresentationWord&) = default;
};

inline std::uint16_t encode(const PresentationWord& word) noexcept {
    return static_cast<std::uint16_t>((word.candidate & 0xFFF) | ((word.arrangement & 0xF) << 12));
}
inline PresentationWord decodePresentation(std::uint16_t argument) noexcept {
    return {argument & 0xFFF, argument >> 12};
}

} // namespace chiron::core
