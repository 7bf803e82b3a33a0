// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace chiron::desktop {

/// Makes Enter press the focused button on every screen and in every dialog, whatever the dialog's default
/// button is. In text fields, tables and all other widgets Enter keeps its own meaning. It is an event filter
/// on the application.
/// Thread: GUI.
class EnterKey final : public QObject {
    Q_OBJECT
public:
    explicit EnterKey(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace chiron::desktop
