// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/study_data/study_facts.h"

#include <QFrame>

namespace chiron::desktop {

class AppContext;

/// Shown for a blinded study whose conditions differ: the quality of each participant's trials over all
/// conditions together, and the reason why nothing more is shown.
/// Thread: GUI; keeps nothing of the facts.
class QualityBox final : public QFrame {
    Q_OBJECT
public:
    QualityBox(AppContext& app, const StudyFacts& facts, QWidget* parent = nullptr);

private:
    QWidget* table(AppContext& app, const StudyFacts& facts);
};

} // namespace chiron::desktop
