// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QPointer>
#include <QWidget>

class QScreen;

namespace chiron::desktop {

/// The participant's window, where the station has a second screen: their page over all of it, and nothing else. Whoever sits there cannot
/// close it. GUI thread.
class ParticipantWindow final : public QWidget {
    Q_OBJECT
public:
    /// A screen that `window` is not on; null: there is none.
    static QScreen* otherScreen(const QWidget& window);

    ParticipantWindow(const Theme& theme, QScreen& screen, QWidget* parent);

    void take(QWidget* page); ///< shows it
    QWidget* giveBack();      ///< the page without a parent, and the window is gone from the screen

signals:
    void lost(); ///< its screen was unplugged or switched off

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    QPointer<QScreen> m_screen;
    QPointer<QWidget> m_page;
};

} // namespace chiron::desktop
