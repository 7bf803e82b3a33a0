// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/force_facts.h"

#include "core/contact_bits.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace chiron::scoring {

namespace {

using Span = std::pair<double, double>; ///< start and end, s

void addTool(const ToolTrace& tool, ForceFacts& facts, std::vector<Span>& limited) {
    const std::size_t count = std::min(tool.t_s.size(), tool.tissue_N.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (i < tool.paused.size() && tool.paused[i] != 0)
            continue;
        ++facts.samples;
        if (i < tool.contact.size() && (tool.contact[i] & core::contact_bits::kBeyondChecked) != 0)
            ++facts.beyondChecked;
        const double tissue_N = tool.tissue_N[i].norm();
        facts.tissue_N = std::max(facts.tissue_N, tissue_N);
        if (i >= tool.commanded_N.size())
            continue;
        const double commanded_N = tool.commanded_N[i].norm();
        facts.commanded_N = std::max(facts.commanded_N, commanded_N);
        if (tissue_N > commanded_N + kLimited_N && i + 1 < count)
            limited.emplace_back(tool.t_s[i], tool.t_s[i + 1]);
    }
}

} // namespace

ForceFacts forceFactsOf(const SessionTrace& trace) {
    ForceFacts facts;
    std::vector<Span> limited;
    for (const TrialTrace& trial : trace.trials)
        if (trial.forcesKnown)
            for (const ToolTrace& tool : trial.tools)
                addTool(tool, facts, limited);
    std::sort(limited.begin(), limited.end());
    double until_s = 0.0;
    for (const auto& [from_s, to_s] : limited) { // time when both tools are limited counts once
        if (!facts.firstLimited_s)
            facts.firstLimited_s = until_s = from_s;
        facts.limited_s += std::max(0.0, to_s - std::max(from_s, until_s));
        until_s = std::max(until_s, to_s);
    }
    return facts;
}

} // namespace chiron::scoring
