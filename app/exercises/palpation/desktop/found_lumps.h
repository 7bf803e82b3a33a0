// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/palpation/scoring/finding_matches.h"
#include "desktop/training/trial_answer.h"

#include <array>
#include <vector>

namespace chiron::desktop {

/// The lumps of a trial that were found, according to its findings.
/// Thread: GUI.
class FoundLumps final : public TrialAnswer {
public:
    void follow(const haptics::DisplayState& state) override;
    /// Nothing is told of a finding before the trial ends.
    QString markWords(const session::TrialObject&, const session::LiveSample&,
                      const QLocale&) const override {
        return markTaken();
    }
    QString endWords(const session::TrialObject& truth, const QLocale& locale) const override;
    bool keep(const session::TrialObject& truth, const std::optional<core::Vec3>& p_WMark) override;
    void show(scene3d::SceneState& drawn) const override;

private:
    using Findings = std::array<simulation::Finding, simulation::kMaxFindings>;

    static std::vector<scoring::FindingMatch> matches(const std::vector<session::TrialLump>& lumps,
                                                      const Findings& findings);

    bool m_palpates = false;
    Findings m_findings{};                       ///< in the newest state of the trial
    Findings m_kept{};                           ///< at the end of the trial that is shown
    std::vector<session::TrialLump> m_keptLumps; ///< of that trial
};

} // namespace chiron::desktop
