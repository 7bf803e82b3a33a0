// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <span>
#include <utility>
#include <vector>

class QKeyEvent;
class QWidget;

namespace chiron::desktop {

/// Handles the keys of the training screen wherever the focus is, also in the native window of the 3D scene.
/// It is an event filter on the application. Esc stops force at once and closes nothing while force may flow.
/// Space pauses and resumes, whatever has the focus. Enter marks, or presses the button that the person moved
/// to with Tab (the screen takes the focus back whenever the hand continues). R re-arms. F5 starts again. The
/// hand's own keys move the tool. Tab leaves the scene for the controls. Ctrl+Page Down and Ctrl+Page Up read
/// on and back in the panel, which a captured pointer cannot reach. While a dialog is open or a text is
/// being typed, only Esc is handled.
/// Thread: GUI.
class KeyFilter final : public QObject {
    Q_OBJECT
public:
    explicit KeyFilter(QWidget& screen);
    ~KeyFilter() override;

    void setScene(QObject* inputSource) { m_scene = inputSource; } ///< may be a window without widgets
    void setActive(bool active);                                   ///< from start to end of the session
    /// While paused or stopped, Esc keeps its usual meaning in dialogs and text fields.
    void setHeld(bool held) { m_held = held; }
    /// While `early` says so, Enter and Space are taken and do nothing: they were meant for what the screen
    /// showed before. By default never.
    void setEarly(std::function<bool()> early) { m_early = std::move(early); }
    /// Empty until the first call.
    void setToolKeys(std::span<const int> keys) { m_toolKeys.assign(keys.begin(), keys.end()); }
    /// F: the exercise has the depth-of-field switch.
    void setDepthOfFieldKey(bool used) { m_depthOfFieldKey = used; }
    /// Ctrl+Page Down and Ctrl+Page Up: the screen has a panel. Otherwise they keep their usual meaning.
    void setPanelKeys(bool used) { m_panelKeys = used; }

signals:
    void stopAsked();
    void pauseAsked();
    void rearmAsked();
    void markAsked();
    void startAgainAsked();
    void depthOfFieldAsked();
    void detailsAsked();        ///< F4
    void panelAsked(bool down); ///< Ctrl+Page Down and Ctrl+Page Up
    void toolKey(int key, bool down);
    void leaveSceneAsked(bool forward); ///< Tab while the scene has the focus

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool elsewhere() const; ///< a dialog is open or a text is being typed
    bool isToolKey(int key) const;
    bool takes(const QKeyEvent& event, QObject* watched) const;
    bool readsPanel(const QKeyEvent& event) const;
    void act(const QKeyEvent& event);

    QWidget& m_screen;
    QPointer<QObject> m_scene;
    bool m_active = false;
    bool m_held = false;
    bool m_depthOfFieldKey = false;
    bool m_panelKeys = false;
    std::vector<int> m_toolKeys;
    std::function<bool()> m_early;
};

} // namespace chiron::desktop
