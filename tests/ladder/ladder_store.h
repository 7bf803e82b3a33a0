// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "ladder/ladder.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::tests {

/// Sessions of the ladder on disk: a file for each level, <exercise>_<number>.jsonl, a line for each session
/// with seed, commit, models id and settings, written as soon as the session has ended. A run that was
/// interrupted goes on where it stopped.
class LadderStore {
public:
    /// What a session was run with.
    struct Sources {
        /// Of the sources. Where files had been changed since, with a digest of the change; without git
        /// "unknown" with a word that is never the same.
        std::string commit;
        std::string models; ///< id of the laws (core/fp_environment.h)
        bool operator==(const Sources&) const = default;
    };
    static Sources present(); ///< of this build
    /// Of the last session that is stored of the level; nothing if there is none.
    static std::optional<Sources> last(const std::string& folder, const catalogue::ExerciseLevel& level);

    /// Makes the folder. Of what is stored there, sessions of other sources are left alone.
    explicit LadderStore(std::string folder, Sources sources = present());

    const Sources& sources() const { return m_sources; }

    /// Sessions of one operator with these settings, of these sources, in the order in which they were run;
    /// where a seed was run again, its last session.
    std::vector<LadderSession> sessions(const catalogue::ExerciseLevel& level,
                                        const std::string& operatorName,
                                        const LadderSettings& settings) const;
    void add(const catalogue::ExerciseLevel& level, const std::string& operatorName,
             const LadderSettings& settings, const LadderSession& session);

private:
    std::string m_folder;
    Sources m_sources;
};

} // namespace chiron::tests
