// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/study_data/study_facts.h"

#include <QFrame>

namespace chiron::desktop {

class AppContext;

/// What is shown of a blinded study whose conditions differ: how well each participant's trials went, over all conditions together, and why no more is
/// shown. GUI thread; keeps nothing of the facts.
class QualityBox final : public QFrame {
    Q_OBJECT
public:
    QualityBox(AppContext& app, const StudyFacts& facts, QWidget* parent = nullptr);

private:
    QWidget* table(AppContext& app, const StudyFacts& facts);
};

} // namespace chiron::desktop
