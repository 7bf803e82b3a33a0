// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact_bits.h"
#include "core/haptic_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace chiron::tests {

/// The part of the commanded force above 20 Hz, in windows of 0.5 s without a change of contact: what a hand
/// feels as shaking. One per session; give it every frame at 1 kHz. Filter: Butterworth high-pass of fourth
/// order, two sections by the bilinear transform.
class FastForce {
public:
    void add(const core::HapticFrame& frame) {
        for (std::uint32_t i = 0; i < frame.tools; ++i)
            addTool(m_tools[i], frame.tool[i],
                    frame.header.paused != 0 || frame.header.force != core::ForceState::on);
        ++m_tick;
    }
    /// Root mean square of the worst window; 0 if there was none.
    double worst_N() const { return m_worst_N; }
    std::uint64_t worstTick() const { return m_worstTick; } ///< its last tick, from the session's first
    std::uint64_t windows() const { return m_windows; }

private:
    static constexpr int kWindow = 500; ///< ticks
    /// Ticks left out after a change of contact: three periods of the cut-off.
    static constexpr int kSettling = 150;

    struct Section {
        double x1 = 0.0, x2 = 0.0, y1 = 0.0, y2 = 0.0;
        double step(double x, double q) {
            static const double k =
                std::tan(3.14159265358979323846 * 20.0 /
                         1000.0); // once: 12 a tick and tool were a twentieth of a session
            const double n = 1.0 / (1.0 + k / q + k * k);
            const double y =
                n * (x - 2.0 * x1 + x2) - 2.0 * n * (k * k - 1.0) * y1 - n * (1.0 - k / q + k * k) * y2;
            x2 = x1;
            x1 = x;
            y2 = y1;
            y1 = y;
            return y;
        }
    };
    struct Tool {
        std::array<std::array<Section, 2>, 3> filter{};
        bool touching = false;
        int quiet = -kSettling; ///< ticks of the open window; negative while the filter settles
        double squares_N2 = 0.0;
    };

    static double squareOf(double x) { return x * x; }

    void addTool(Tool& tool, const core::ToolFrame& frame, bool off) {
        double fast2 = 0.0;
        for (std::size_t c = 0; c < 3; ++c) // the poles' qualities of a Butterworth of fourth order
            fast2 += squareOf(
                tool.filter[c][1].step(tool.filter[c][0].step(frame.commanded[c], 0.54119610), 1.30656296));
        const bool touching = std::hypot(frame.tissue[0], frame.tissue[1], frame.tissue[2]) > 0.0;
        const bool breaking = core::contactOfStatus(frame.status) & core::contact_bits::kThrough;
        if (touching != tool.touching || breaking || off) {
            tool.touching = touching;
            tool.quiet = -kSettling;
            tool.squares_N2 = 0.0;
            return;
        }
        if (++tool.quiet <= 0)
            return;
        tool.squares_N2 += fast2;
        if (tool.quiet < kWindow)
            return;
        ++m_windows;
        if (const double rms_N = std::sqrt(tool.squares_N2 / kWindow); rms_N > m_worst_N) {
            m_worst_N = rms_N;
            m_worstTick = m_tick;
        }
        tool.quiet = 0;
        tool.squares_N2 = 0.0;
    }

    std::array<Tool, core::kMaxTools> m_tools{};
    std::uint64_t m_tick = 0, m_worstTick = 0, m_windows = 0;
    double m_worst_N = 0.0;
};

} // namespace chiron::tests
