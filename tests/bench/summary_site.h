// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/sample_rows.h"
#include "core/result.h"
#include "database/database.h"
#include "database/repositories/session_types.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace chiron::bench {

/// A site of the product's own database: sessions recorded by the product's own run, and copies of their rows
/// of `session` and `second_summary` under further ids.
class SummarySite {
public:
    explicit SummarySite(const std::filesystem::path& file);
    SummarySite(const SummarySite&) = delete;
    SummarySite& operator=(const SummarySite&) = delete;
    ~SummarySite();

    /// Runs ten minutes of haptics alone by a scripted operator, which varies with the seed.
    core::Result<bool> record(std::uint64_t seed);
    /// Copies the recorded sessions' summaries until there are `sessions` of them; no more recording after
    /// this.
    core::Result<bool> replicate(int sessions);

    core::Result<Totals> ask(int recorded);                  ///< of the n-th recorded session, from summaries
    core::Result<std::vector<Totals>> askAll();              ///< of every session, from summaries
    core::Result<std::vector<Sample>> samples(int recorded); ///< from its chunks
    std::int64_t summaryRows() const noexcept { return m_summaryRows; }
    std::uint64_t sampleBytes() const noexcept { return m_sampleBytes; }

private:
    std::string m_file;
    std::unique_ptr<database::Database> m_database;
    std::unique_ptr<database::Connection> m_reader;
    std::vector<database::SessionId> m_recorded;
    std::int64_t m_summaryRows = 0;
    std::uint64_t m_sampleBytes = 0;
};

} // namespace chiron::bench
