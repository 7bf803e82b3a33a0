// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/design_faults.h"
#include "psychophysics/planning/study_plan.h"

#include <QLocale>
#include <QString>
#include <optional>
#include <vector>

namespace chiron::desktop {

/// The result of one check before a design is frozen.
struct FreezeCheck {
    enum class State {
        good,
        advice, ///< may be intended
        bad,    ///< prevents freezing
        waiting ///< still being determined
    };
    QString name; ///< for example "aim"; object names end with it
    State state = State::good;
    QString title;
    QString words; ///< the finding, and what to do
    int tab = 0;   ///< page on which to correct it; -1: it is no matter of the design
    int condition = -1;
    QString field; ///< empty: no particular field
};

/// The facts that the checks use.
struct FreezeFacts {
    std::vector<DesignFault> faults;
    /// For each condition, from simulated observers; no value: not available yet.
    std::optional<std::vector<psychophysics::ConditionPlan>> plans;
    int pilots = 0; ///< number of people who tried the design
    /// Whether the device with which this station runs studies renders force; no value: not asked.
    std::optional<bool> rendersForce{};
    std::optional<bool> hasSound{}; ///< whether this station has sound output; no value: not yet tested
};

std::vector<FreezeCheck> freezeChecks(const psychophysics::StudyDesign& design, const FreezeFacts& facts,
                                      const QLocale& locale);

/// Why a design with these checks cannot be frozen now, and what to do, to stand beside the button; empty if
/// it can be. `seen`: what is worth a look was confirmed.
QString whyNotFrozen(const std::vector<FreezeCheck>& checks, bool seen);

/// The number of participants must be a multiple of this for every order of conditions to occur equally
/// often; 1 if that does not matter.
int balancedBy(const psychophysics::StudyDesign& design);

} // namespace chiron::desktop
