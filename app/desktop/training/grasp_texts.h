// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace chiron::desktop {

/// The translation contexts of texts about graspers: steps and held objects, and the numbers beside them.
struct GraspTexts {
    Q_DECLARE_TR_FUNCTIONS(GraspWords)
};
struct GraspPanelTexts {
    Q_DECLARE_TR_FUNCTIONS(chiron::desktop::GraspPanel)
};

} // namespace chiron::desktop
