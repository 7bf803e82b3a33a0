// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/command_list.h"
#include "desktop/frame/place.h"

#include <QMainWindow>

class QHBoxLayout;
class QVBoxLayout;

namespace chiron::desktop {

class AppContext;
class MessageBar;
class PaletteFinder;
struct Message;
class Screen;
class SideBar;

/// The window: navigation, the present screen, messages. Builds the screens that the navigator asks for, and everything
/// anew when the appearance changes. GUI thread.
class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(AppContext& context);
    ~MainWindow() override;

    Screen* screen() const { return m_screen; }

signals:
    void firstPainted(); ///< once: what is slow to load may begin

protected:
    void closeEvent(QCloseEvent* event) override;
    bool event(QEvent* event) override;

private:
    void build();
    void showPlace(const Place& place);
    void rebuild();
    void renewShortcuts();
    void showCommandPalette();
    QWidget* banner() const;
    QWidget* statusLine() const;
    void tell(const Message& message);
    void showMessageRoom(const Place& place);

    AppContext& m_context;
    WindowActions m_actions;
    PaletteFinder* m_finder = nullptr;
    QObject* m_shortcuts = nullptr; ///< parent of the keys that work now
    QWidget* m_frame = nullptr;
    SideBar* m_sideBar = nullptr;     ///< null before somebody is logged in
    QVBoxLayout* m_column = nullptr;
    QWidget* m_banner = nullptr;      ///< made when it is first needed, as the messages are
    MessageBar* m_messages = nullptr;
    QWidget* m_messageRoom = nullptr; ///< below the screen, so that no message covers a control or moves one
    QVBoxLayout* m_stage = nullptr;
    Screen* m_screen = nullptr;
    bool m_rebuildWanted = false;
    bool m_painted = false;
};

} // namespace chiron::desktop
