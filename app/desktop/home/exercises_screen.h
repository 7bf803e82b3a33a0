// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"

namespace chiron::desktop {

class StatePanel;

/// Lists every exercise with its levels and the person's standing at each. Everybody may open it, because
/// whoever may log in may train.
class ExercisesScreen final : public Screen {
    Q_OBJECT
public:
    ExercisesScreen(AppContext& context, const Place& place);

    QString title() const override;
    void enter() override;
    QString help() const override;

private:
    void load();

    StatePanel* m_panel;
};

} // namespace chiron::desktop
