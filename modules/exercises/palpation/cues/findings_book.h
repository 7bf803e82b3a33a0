// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/cues/report_word.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace chiron::simulation {

/// The findings that a person has reported in one trial of a palpation. This class alone defines the effect
/// of a report: the scene uses it when a report arrives, playback and scoring when they read the recording.
/// Fixed size.
/// Thread: a single one; allocates nothing.
class FindingsBook {
public:
    static constexpr int kNone = -1;
    static constexpr unsigned kHighestRating = 5;

    void clear() noexcept { *this = FindingsBook{}; }

    /// Stores a new finding at `p_W` (on the surface) in the first free place and selects it. Returns its
    /// number, or kNone if all places are taken.
    int found(const std::array<double, 3>& p_W) noexcept {
        for (std::size_t i = 0; i < kMaxFindings; ++i)
            if (!m_findings[i].present) {
                place(static_cast<int>(i), p_W);
                return m_selected;
            }
        return kNone;
    }
    /// Stores a finding under a known number, as a recording states it. Does nothing if the number is out of
    /// range.
    void place(int finding, const std::array<double, 3>& p_W) noexcept {
        if (finding < 0 || static_cast<std::size_t>(finding) >= kMaxFindings)
            return;
        m_findings[static_cast<std::size_t>(finding)] = Finding{true, p_W, 0.0, 0, 0};
        m_selected = finding;
    }
    /// Applies a report word. Returns the finding that it was about, or kNone if it had no effect (no such
    /// finding, no such value). `done` is about no finding and is always accepted.
    int report(ReportField field, unsigned value) noexcept {
        switch (field) {
        case ReportField::found:
            return kNone; // a mark needs a position: see found()
        case ReportField::done:
            m_done = true;
            return kNone;
        case ReportField::select:
            return has(static_cast<int>(value)) ? m_selected = static_cast<int>(value) : kNone;
        case ReportField::remove:
            return remove(static_cast<int>(value));
        case ReportField::size:
        case ReportField::hardness:
        case ReportField::confidence:
            return rate(m_selected, field, value);
        }
        return kNone;
    }
    /// Applies a rating to a given finding, as a recording states it.
    int rate(int finding, ReportField field, unsigned value) noexcept {
        if (!has(finding))
            return kNone;
        Finding& about = m_findings[static_cast<std::size_t>(finding)];
        if (field == ReportField::size)
            about.radius_m = 1e-4 * std::min<unsigned>(value, kReportValueMask);
        else if (value > kHighestRating)
            return kNone;
        else if (field == ReportField::hardness)
            about.hardness = static_cast<std::uint8_t>(value);
        else if (field == ReportField::confidence)
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
        return finding >= 0 && static_cast<std::size_t>(finding) < kMaxFindings &&
               m_findings[static_cast<std::size_t>(finding)].present;
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
