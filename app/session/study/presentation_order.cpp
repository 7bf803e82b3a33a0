// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/presentation_order.h"

#include "core/random.h"
#include "psychophysics/planning/run_simulator.h"
#include "psychophysics/procedures/procedure_catalogue.h"

#include <numeric>
#include <string>

namespace chiron::session {

int balancedArrangement(psychophysics::Task task, std::uint64_t seed, const PresentationPlace& place) {
    const int count = static_cast<int>(psychophysics::arrangements(task).size());
    if (place.practice || place.repeat > 0) {
        core::Random random = core::Random::stream(seed, "study.again " + std::to_string(place.ordinal));
        return static_cast<int>(random.below(static_cast<std::uint64_t>(count)));
    }
    std::vector<int> block(static_cast<std::size_t>(count));
    std::iota(block.begin(), block.end(), 0);
    core::Random random = core::Random::stream(seed, "study.arrangement " + std::to_string(place.procedure) +
                                                         " " + std::to_string(place.trial / count));
    for (std::size_t i = block.size(); i > 1; --i) // Fisher & Yates
        std::swap(block[i - 1], block[static_cast<std::size_t>(random.below(i))]);
    return block[static_cast<std::size_t>(place.trial % count)];
}

int trialsAtMost(const psychophysics::Condition& condition) {
    int sum = 0;
    for (const psychophysics::ProcedureSpec& procedure : condition.procedures) {
        const int most = psychophysics::kindFor(procedure).trialsAtMost(procedure);
        if (most <= 0)
            return 0;
        sum += most;
    }
    // Procedures count only trials that show their difference, but every block of arrangements also contains
    // others.
    const auto& all = psychophysics::arrangements(condition.task);
    int showing = 0;
    for (int i = 0; i < static_cast<int>(all.size()); ++i)
        showing += psychophysics::showsDifference(condition.task, i) ? 1 : 0;
    return sum * static_cast<int>(all.size()) / showing;
}

} // namespace chiron::session
