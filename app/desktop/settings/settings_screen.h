// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"

namespace chiron::desktop {

/// Appearance and sound of the program on this station: language, theme, scale, sound. Changes take effect at
/// once.
class SettingsScreen final : public Screen {
    Q_OBJECT
public:
    SettingsScreen(AppContext& context, const Place& place);

    QString title() const override;
    QString help() const override;

private:
    QWidget* languageBox();
    QWidget* themeBox();
    QWidget* scaleBox();
    QWidget* soundBox();
};

} // namespace chiron::desktop
