// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report_word.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace chiron::simulation {

/// What a person has reported in one trial of a palpation: the one place that says what a report does, for the scene that takes
/// it, for playback and for scoring, which read it back from the recording. Fixed size; nothing allocates. One thread.
class FindingsBook {
public:
    static constexpr int kNone = -1;
    static constexpr unsigned kHighestRating = 5;

    void clear() noexcept { *this = FindingsBook{}; }

    /// A new finding at `p_W` (on the surface), in the first free place, and selected. Its number, or kNone if all are taken.
    int found(const std::array<double, 3>& p_W) noexcept {
        for (std::size_t i = 0; i < kMaxFindings; ++i)
            if (!m_findings[i].present) {
                place(static_cast<int>(i), p_W);
                return m_selected;
            }
        return kNone;
    }
    /// The same with a known number, as a recording tells it; out of range: nothing.
    void place(int finding, const std::array<double, 3>& p_W) noexcept {
        if (finding < 0 || static_cast<std::size_t>(finding) >= kMaxFindings)
            return;
        m_findings[static_cast<std::size_t>(finding)] = Finding{true, p_W, 0.0, 0, 0};
        m_selected = finding;
    }
    /// A report word. The finding that it was about, kNone where it meant nothing (no such finding, no such value); `done` is
    /// about none and is always taken.
    int report(core::ReportField field, unsigned value) noexcept {
        switch (field) {
        case core::ReportField::found:
            return kNone; // marks have a place: found()
        case core::ReportField::done:
            m_done = true;
            return kNone;
        case core::ReportField::select:
            return has(static_cast<int>(value)) ? m_selected = static_cast<int>(value) : kNone;
        case core::ReportField::remove:
            return remove(static_cast<int>(value));
        case core::ReportField::size:
        case core::ReportField::hardness:
        case core::ReportField::confidence:
            return rate(m_selected, field, value);
        }
        return kNone;
    }
    /// A rating of a given finding, as a recording tells it.
    int rate(int finding, core::ReportField field, unsigned value) noexcept {
        if (!has(finding))
            return kNone;
        Finding& about = m_findings[static_cast<std::size_t>(finding)];
        if (field == core::ReportField::size)
            about.radius_m = 1e-4 * std::min<unsigned>(value, core::kReportValueMask);
        else if (value > kHighestRating)
            return kNone;
        else if (field == core::ReportField::hardness)
            about.hardness = static_cast<std::uint8_t>(value);
        else if (field == core::ReportField::confidence)
            about.confidence = static_cast<std::uint8_t>(value);
        return finding;
    }
    int remove(int finding) noexcept {
        if (!has(finding))
            return kNone;
        m_findings[static_cast<std::size_t>(finding)] = Finding{};
        if (m_selected == finding)
            m_selected = kNone;
        return finding;
    }

    bool has(int finding) const noexcept {
        return finding >= 0 && static_cast<std::size_t>(finding) < kMaxFindings && m_findings[static_cast<std::size_t>(finding)].present;
    }
    const std::array<Finding, kMaxFindings>& list() const noexcept { return m_findings; }
    int selected() const noexcept { return m_selected; } ///< kNone: none
    bool done() const noexcept { return m_done; }

private:
    std::array<Finding, kMaxFindings> m_findings{};
    int m_selected = kNone;
    bool m_done = false;
};

} // namespace chiron::simulation
