// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace chiron::psychophysics {

/// Graph of which object was ever preferred to which. The maximum likelihood exists if and only if every
/// object can be reached from every other (Ford 1957).
class WinGraph {
public:
    explicit WinGraph(int objects)
        : m_beaten(static_cast<std::size_t>(objects)), m_beatenBy(m_beaten.size()) {}

    void add(int winner, int loser) {
        m_beaten[static_cast<std::size_t>(winner)].push_back(loser);
        m_beatenBy[static_cast<std::size_t>(loser)].push_back(winner);
    }
    bool isStronglyConnected() const { return reachesAll(m_beaten) && reachesAll(m_beatenBy); }

private:
    static bool reachesAll(const std::vector<std::vector<int>>& next) {
        std::vector<bool> seen(next.size(), false);
        std::vector<std::size_t> open{0};
        std::size_t reached = 0;
        seen[0] = true;
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            ++reached;
            for (const int to : next[at])
                if (!seen[static_cast<std::size_t>(to)]) {
                    seen[static_cast<std::size_t>(to)] = true;
                    open.push_back(static_cast<std::size_t>(to));
                }
        }
        return reached == next.size();
    }

    std::vector<std::vector<int>> m_beaten;
    std::vector<std::vector<int>> m_beatenBy;
};

} // namespace chiron::psychophysics
