// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace chiron::desktop {

/// Keeps the wheel from changing a closed choice or a number: the page under the pointer scrolls instead.
/// Otherwise, whoever scrolls a page across such a field changes it without noticing. It is an event filter
/// on the application. Thread: GUI.
class StillWheel final : public QObject {
    Q_OBJECT
public:
    explicit StillWheel(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace chiron::desktop
