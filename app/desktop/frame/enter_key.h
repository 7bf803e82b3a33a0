// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace chiron::desktop {

/// Enter presses the button that has the focus, on every screen and in every dialog, whatever the dialog's default is. Text fields, tables
/// and everything else keep their own meaning of Enter. A filter on the application. GUI thread.
class EnterKey final : public QObject {
    Q_OBJECT
public:
    explicit EnterKey(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace chiron::desktop
