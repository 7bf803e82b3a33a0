// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <initializer_list>
#include <utility>
#include <vector>

class QBoxLayout;
class QPushButton;

namespace chiron::desktop {

class AppContext;

/// Navigation at the left: the screens that the person's roles allow, who is logged in, lock and switch user.
/// It is rebuilt on every change of person or appearance.
/// Thread: GUI.
class SideBar final : public QWidget {
    Q_OBJECT
public:
    explicit SideBar(AppContext& context, QWidget* parent = nullptr);
    void showCurrent(const QString& screen);

signals:
    void paletteAsked();
    void helpAsked();

private:
    QWidget* entries();
    QWidget* personArea();
    void showUnread(int sessions); ///< on the Home entry, because Home lists these sessions
    QBoxLayout* inOnePlace(std::initializer_list<QPushButton*> buttons) const;
    QPushButton* entry(const QString& icon, const QString& text, const QString& name);

    AppContext& m_context;
    std::vector<std::pair<QString, QPushButton*>> m_buttons;
};

} // namespace chiron::desktop
