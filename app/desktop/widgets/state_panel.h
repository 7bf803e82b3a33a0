// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "desktop/frame/messages.h"
#include "desktop/theme/theme.h"

#include <QStackedWidget>
#include <functional>
#include <memory>

class QLabel;
class QProgressBar;
class QPushButton;
class QTimer;

namespace chiron::desktop {

class WorkToken;

/// A part of a screen that is loading, empty, failed, or there. Every list and every loaded thing sits in one, so that all
/// screens say these states alike. Progress appears after 0.5 s, Cancel after 2 s (experience.md, Rules). GUI thread.
class StatePanel : public QStackedWidget {
    Q_OBJECT
public:
    explicit StatePanel(const Theme& theme, QWidget* parent = nullptr);

    /// What is shown once it is there; the panel owns it.
    void setContent(QWidget* content);
    QWidget* content() const { return m_content; }

    /// `what` says what is being done ("Loading the sessions …"). With a token: progress and Cancel.
    void showLoading(const QString& what, std::shared_ptr<WorkToken> token = {});
    void showContent();
    /// Nothing is there yet: why, and what to do about it (button hidden where the text is empty).
    void showEmpty(const QString& title, const QString& text, const QString& actionText = {}, std::function<void()> action = {});
    /// It failed: in words, with "Try again" where that makes sense.
    void showError(const QString& title, const core::Error& error, std::function<void()> again = {}, Tried tried = Tried::reading);

    enum class State { loading, content, empty, error };
    State state() const noexcept { return m_state; }

private:
    void showNote(const QString& icon, Colour ink, const QString& title, const QString& text, const QString& actionText,
                  std::function<void()> action);
    void buildNote();
    void buildLoading();
    void buildProgress();
    void revealProgress();

    const Theme& m_theme;
    State m_state = State::loading;
    QWidget* m_content = nullptr;
    QWidget* m_loading = nullptr;
    QLabel* m_loadingText = nullptr;
    QString m_what; ///< is being loaded
    QProgressBar* m_progress = nullptr;
    QPushButton* m_cancel = nullptr;
    QTimer* m_timer = nullptr;
    int m_elapsed_ms = 0;
    std::shared_ptr<WorkToken> m_token;
    QWidget* m_note = nullptr;
    QLabel* m_noteIcon = nullptr;
    QLabel* m_noteTitle = nullptr;
    QLabel* m_noteText = nullptr;
    QPushButton* m_noteAction = nullptr;
    std::function<void()> m_action;
};

} // namespace chiron::desktop
