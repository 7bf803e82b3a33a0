// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace chiron::desktop {

class ScrollPage;

/// Replaces the scene between trials: instructions, a break with its countdown, the end.
/// Thread: GUI.
class BreakPanel final : public QWidget {
    Q_OBJECT
public:
    explicit BreakPanel(const Theme& theme, QWidget* parent = nullptr);

    /// `action` is the label of the button; if it is empty, there is no button.
    void say(const QString& title, const QString& text, const QString& action);
    /// Shows a countdown of `left_s` out of `of_s` and disables the button until its end. A negative value
    /// hides it.
    void countDown(double left_s, double of_s);
    void focusButton(); ///< once the end of the text is visible; before, the panel has the focus
    /// Shows more of a text that is longer than the window; false: its end is visible, and the button is
    /// next.
    bool readOn();
    /// Shows a second, quiet button below; empty: none. The next say() removes it.
    void offer(const QString& more);

signals:
    void acted();
    void moreAsked();

protected:
    void keyPressEvent(QKeyEvent* event) override; ///< Enter reads on, then presses the button

private:
    ScrollPage* m_page;
    QLabel* m_title;
    QLabel* m_text;
    QProgressBar* m_bar;
    QPushButton* m_button;
    QPushButton* m_more;
};

} // namespace chiron::desktop
