// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

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

inline Measurement noSamples() {
    return Measurement::undefined("no samples");
}

} // namespace chiron::scoring
