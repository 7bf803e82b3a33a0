// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QPointer>
#include <QWidget>

class QScreen;

namespace chiron::desktop {

/// The participant's window if the station has a second screen. Their page fills all of that screen. The
/// participant cannot close it.
/// Thread: GUI.
class ParticipantWindow final : public QWidget {
    Q_OBJECT
public:
    /// A screen that `window` is not on; null if there is none.
    static QScreen* otherScreen(const QWidget& window);

    ParticipantWindow(const Theme& theme, QScreen& screen, QWidget* parent);

    void take(QWidget* page); ///< shows this page
    QWidget* giveBack();      ///< returns the page without a parent and hides the window

signals:
    void lost(); ///< the window's screen was unplugged or switched off

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    QPointer<QScreen> m_screen;
    QPointer<QWidget> m_page;
};

} // namespace chiron::desktop
