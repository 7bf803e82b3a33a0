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

/// A part of a screen that is loading, empty, failed, or has content. Every list and everything that is
/// loaded sits in a StatePanel, so that all screens present these states in the same way. Progress appears
/// after 0.5 s, Cancel after 2 s (experience.md, Rules).
/// Thread: GUI.
class StatePanel : public QStackedWidget {
    Q_OBJECT
public:
    explicit StatePanel(const Theme& theme, QWidget* parent = nullptr);

    /// The widget to show after loading. The panel owns it.
    void setContent(QWidget* content);
    QWidget* content() const { return m_content; }

    /// `what` names the work ("Loading the sessions …"). With a token, progress and Cancel appear.
    void showLoading(const QString& what, std::shared_ptr<WorkToken> token = {});
    void showContent();
    /// Shows that there is nothing yet, why, and what to do about it (no button if `actionText` is empty).
    void showEmpty(const QString& title, const QString& text, const QString& actionText = {},
                   std::function<void()> action = {});
    /// Shows an error in words, with "Try again" if `again` is given.
    void showError(const QString& title, const core::Error& error, std::function<void()> again = {},
                   Tried tried = Tried::reading);

    enum class State { loading, content, empty, error };
    State state() const noexcept { return m_state; }

private:
    void showNote(const QString& icon, Colour ink, const QString& title, const QString& text,
                  const QString& actionText, std::function<void()> action);
    void buildNote();
    void buildLoading();
    void buildProgress();
    void revealProgress();

    const Theme& m_theme;
    State m_state = State::loading;
    QWidget* m_content = nullptr;
    QWidget* m_loading = nullptr;
    QLabel* m_loadingText = nullptr;
    QString m_what; ///< text of what is being loaded
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
