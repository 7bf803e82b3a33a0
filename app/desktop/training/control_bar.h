// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>

class QPushButton;

namespace chiron::desktop {

/// The buttons of a running session: stop force (large), pause / resume / re-arm on one button, resume here,
/// start again, end.
/// Thread: GUI.
class ControlBar final : public QWidget {
    Q_OBJECT
public:
    enum class Main { pause, resume, rearm };

    explicit ControlBar(const Theme& theme, QWidget* parent = nullptr);

    void setMain(Main main);
    void setResumeHere(bool possible); ///< shown only while it has an effect
    /// False while a card over the scene has the button that goes on: one of them is enough. Its room is
    /// kept.
    void setMainShown(bool shown);
    void setRunning(bool running); ///< false before the session starts and after it has ended
    void setPractice(); ///< a practice can be ended in favour of the real session, but not started again
    QPushButton* mainButton() const { return m_main; }

signals:
    void stopAsked();
    void mainAsked(chiron::desktop::ControlBar::Main main);
    void resumeHereAsked();
    void startAgainAsked();
    void endAsked();

private:
    QPushButton* add(const QString& text, const char* kind, const QString& icon, const QString& name);

    const Theme& m_theme;
    Main m_is = Main::resume;
    bool m_running = false;
    QPushButton* m_stop;
    QPushButton* m_main;
    QPushButton* m_resumeHere;
    QPushButton* m_again;
    QPushButton* m_end;
};

} // namespace chiron::desktop
