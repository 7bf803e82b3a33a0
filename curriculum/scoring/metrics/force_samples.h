// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact_bits.h"
#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace chiron::scoring {

/// Calls visit(‖tissue force‖ N, seconds it was held) for each unpaused sample of the first tool. A sample's
/// force holds until the next one, as the loop holds it for a tick; the trial's last sample holds for no
/// time.
template <class Visit> void forEachForce(std::span<const PreparedTrial> trials, Visit&& visit) {
    for (const PreparedTrial& trial : trials) {
        if (trial.tool == nullptr)
            continue;
        const ToolTrace& tool = *trial.tool;
        for (std::size_t i = 0; i < tool.t_s.size(); ++i)
            if (!tool.paused[i])
                visit(tool.tissue_N[i].norm(), i + 1 < tool.t_s.size() ? tool.t_s[i + 1] - tool.t_s[i] : 0.0);
    }
}

/// Calls visit(load N, seconds it was held, whether anything was touched) for each unpaused sample of every tool. The load is the tissue
/// force; from where tissue has given way until the tool is out of it, at least the force at which it gave way: who has broken tissue
/// has not become gentle. Touched: over 0.02 N, or broken.
template <class Visit> void forEachLoad(std::span<const PreparedTrial> trials, Visit&& visit) {
    for (const PreparedTrial& trial : trials)
        for (const ToolTrace& tool : trial.trial->tools) {
            double broke_N = 0.0;
            for (std::size_t i = 0; i < tool.t_s.size(); ++i) {
                const double force_N = tool.tissue_N[i].norm();
                const bool broken = i < tool.contact.size() && (tool.contact[i] & core::contact_bits::kThrough) != 0;
                broke_N = broken ? std::max(broke_N, force_N) : 0.0;
                if (tool.paused[i])
                    continue;
                const double load_N = std::max(force_N, broke_N);
                visit(load_N, i + 1 < tool.t_s.size() ? tool.t_s[i + 1] - tool.t_s[i] : 0.0, broken || load_N > kContactForce_N);
            }
        }
}

inline Measurement noSamples() {
    return Measurement::undefined(UndefinedReason::noSamples);
}

} // namespace chiron::scoring
