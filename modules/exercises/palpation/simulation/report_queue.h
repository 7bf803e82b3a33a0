// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/tool_state.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/cues/report_word.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace chiron::simulation {

/// One report by a person that has not been taken yet.
struct PalpationReport {
    ReportField field = ReportField::done;
    unsigned value = 0;
    core::Vec3 p_W = core::Vec3::Zero(); ///< `found`: position on the surface at the time of the report
};

/// Reports in the order in which they were given. They are taken one by one, so that each has its own
/// recorded row. Fixed size: nobody reports that much at once, and reports that do not fit are dropped.
/// Thread: a single one.
class ReportQueue {
public:
    static constexpr std::size_t kRoom = 32;

    void clear() noexcept { m_first = m_count = 0; }
    bool empty() const noexcept { return m_count == 0; }
    bool put(const PalpationReport& report) noexcept {
        if (m_count == kRoom)
            return false;
        m_reports[(m_first + m_count++) % kRoom] = report;
        return true;
    }
    /// Removes and returns the oldest report. Precondition: not empty().
    PalpationReport take() noexcept {
        const PalpationReport report = m_reports[m_first];
        m_first = (m_first + 1) % kRoom;
        --m_count;
        return report;
    }

private:
    std::array<PalpationReport, kRoom> m_reports{};
    std::size_t m_first = 0;
    std::size_t m_count = 0;
};

/// Detects the edges of the buttons of every tool, so that holding a button down counts once.
/// Thread: a single one.
class ReportButtons {
public:
    /// Call in every tick, including paused ones, so that a button pressed during a pause is ignored.
    void follow(const core::ToolStates& tools, int count) noexcept {
        for (std::size_t i = 0; i < static_cast<std::size_t>(core::kMaxTools); ++i) {
            const std::uint32_t down = static_cast<int>(i) < count ? tools.tools[i].buttons : 0;
            m_edges[i] = down & ~m_down[i];
            m_down[i] = down;
        }
    }
    bool marked(std::size_t tool) const noexcept { return (m_edges[tool] & core::kButtonMark) != 0; }
    bool reported(std::size_t tool) const noexcept { return (m_edges[tool] & core::kButtonReport) != 0; }
    std::uint16_t word(std::size_t tool) const noexcept {
        return static_cast<std::uint16_t>(m_down[tool] >> 16);
    }

private:
    std::array<std::uint32_t, core::kMaxTools> m_down{};
    std::array<std::uint32_t, core::kMaxTools> m_edges{};
};

} // namespace chiron::simulation
