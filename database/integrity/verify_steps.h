// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/connection.h"
#include "database/integrity/verifier.h"

#include <cstdint>

namespace chiron::database {

/// Counts the progress of a verification and regularly asks its watch whether to continue. The scores of one
/// session count as many steps as the rows that take the same time.
class VerifySteps {
public:
    static constexpr std::uint64_t kStepsOfSession = 500;
    static constexpr std::uint64_t kAskEvery = 64;

    VerifySteps(const VerifyWatch& watch, VerifyReport& report) : m_watch(watch), m_report(report) {}
    /// Determines how much there is to do. Tables that cannot be counted are left out, so that the end comes
    /// early.
    void plan(Connection& connection, bool withScores);
    void add(std::uint64_t steps = 1);
    bool goOn() const noexcept { return !m_report.cancelled; }

private:
    const VerifyWatch& m_watch;
    VerifyReport& m_report;
    std::uint64_t m_done = 0;
    std::uint64_t m_of = 0;
    std::uint64_t m_askedAt = 0;
};

} // namespace chiron::database
