// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/design_faults.h"
#include "psychophysics/planning/study_plan.h"

#include <QLocale>
#include <QString>
#include <optional>
#include <vector>

namespace chiron::desktop {

/// One line of what is looked at before a design is frozen.
struct FreezeCheck {
    enum class State {
        good,
        advice, ///< may be so on purpose
        bad,    ///< nobody freezes such a design
        waiting ///< is being found out
    };
    QString name;  ///< "aim"; object names end with it
    State state = State::good;
    QString title;
    QString words; ///< what was found, and what to do
    int tab = 0;   ///< where it is put right
    int condition = -1;
    QString field; ///< empty: none in particular
};

/// What the checks go by.
struct FreezeFacts {
    std::vector<DesignFault> faults;
    std::optional<std::vector<psychophysics::ConditionPlan>> plans; ///< of each condition, by simulated observers; nothing: not yet
    int pilots = 0; ///< people who tried the design
    std::optional<bool> hasSound{}; ///< whether this station can be heard; nothing: nobody has looked
};

std::vector<FreezeCheck> freezeChecks(const psychophysics::StudyDesign& design, const FreezeFacts& facts, const QLocale& locale);

/// The multiple of participants at which every order of conditions comes equally often; 1 where that does not matter.
int balancedBy(const psychophysics::StudyDesign& design);

} // namespace chiron::desktop
