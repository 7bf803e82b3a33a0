// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/palpation/scoring/finding_matches.h"
#include "desktop/training/found_answer.h"

#include <array>
#include <vector>

namespace chiron::desktop {

/// The lumps of a trial that were found, according to its findings.
/// Thread: GUI.
class FoundLumps final : public FoundAnswer {
public:
    void follow(const haptics::DisplayState& state) override;
    bool answers() const override { return m_palpates; }
    QString words(const session::TrialObject& truth, const QLocale& locale) const override;
    void keep() override { m_kept = m_findings; }
    void show(const session::TrialObject& truth, scene3d::SceneState& drawn) const override;

private:
    using Findings = std::array<simulation::Finding, simulation::kMaxFindings>;

    static std::vector<scoring::FindingMatch> matches(const session::TrialObject& object,
                                                      const Findings& findings);

    bool m_palpates = false;
    Findings m_findings{}; ///< in the newest state of the trial
    Findings m_kept{};     ///< at the end of the trial that is shown
};

} // namespace chiron::desktop
