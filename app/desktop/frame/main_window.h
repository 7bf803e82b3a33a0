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

/// The main window, with the navigation, the current screen and the messages. It builds the screens that the
/// navigator asks for, and rebuilds everything when the appearance changes.
/// Thread: GUI.
class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(AppContext& context);
    ~MainWindow() override;

    Screen* screen() const { return m_screen; }

signals:
    void firstPainted(); ///< emitted once; slow loading may start now

protected:
    void closeEvent(QCloseEvent* event) override;
    bool event(QEvent* event) override;

private:
    void build();
    void addSideBar();
    void renewNavigation();
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
    QObject* m_shortcuts = nullptr; ///< parent of the active shortcuts
    QWidget* m_frame = nullptr;
    SideBar* m_sideBar = nullptr; ///< null before login
    QVBoxLayout* m_column = nullptr;
    QWidget* m_banner = nullptr; ///< created when first needed, like the messages
    MessageBar* m_messages = nullptr;
    /// Lies below the screen, so that a message neither covers a control nor moves one.
    QWidget* m_messageRoom = nullptr;
    QVBoxLayout* m_stage = nullptr;
    Screen* m_screen = nullptr;
    bool m_rebuildWanted = false;
    bool m_painted = false;
};

} // namespace chiron::desktop
