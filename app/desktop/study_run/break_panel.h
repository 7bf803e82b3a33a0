// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace chiron::desktop {

/// What stands in the place of the scene while nothing is explored: instructions, a break with its countdown, the end. GUI thread.
class BreakPanel final : public QWidget {
    Q_OBJECT
public:
    explicit BreakPanel(const Theme& theme, QWidget* parent = nullptr);

    /// `action`: what the button says; empty: no button.
    void say(const QString& title, const QString& text, const QString& action);
    /// A countdown of `left_s` of `of_s`; the button waits for its end. Negative: none.
    void countDown(double left_s, double of_s);
    void focusButton();
    /// A second, quiet button below; empty: none. What say() says next has none.
    void offer(const QString& more);

signals:
    void acted();
    void moreAsked();

protected:
    void keyPressEvent(QKeyEvent* event) override; ///< Enter, on the button

private:
    QLabel* m_title;
    QLabel* m_text;
    QProgressBar* m_bar;
    QPushButton* m_button;
    QPushButton* m_more;
};

} // namespace chiron::desktop
