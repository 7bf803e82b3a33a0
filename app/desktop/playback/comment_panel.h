// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/playback/moment_words.h"
#include "desktop/playback/playback_data.h"
#include "desktop/theme/theme.h"

#include <QLocale>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

class QLabel;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

/// Comments at a moment of the recording: a list that seeks, and a field for another one at the moment that is shown. GUI
/// thread.
class CommentPanel : public QWidget {
    Q_OBJECT
public:
    CommentPanel(const Theme& theme, const QLocale& locale, MomentWords moments, QWidget* parent = nullptr);

    /// `timeOf` gives the recording's time of a tick. In the order of time, those on the session as a whole first; a reply
    /// belongs to the moment of what it answers and stands below it.
    void show(std::vector<NamedComment> comments, database::PersonId reader, const std::function<double(std::uint64_t)>& timeOf);
    void setMoment(double t_s); ///< where a new comment would go
    void setMayAdd(bool may);    ///< what the screen offers; what is permitted is checked where it is stored
    void setMayReview(bool may); ///< somebody else's session can be marked as reviewed without a remark
    bool mayAdd() const;
    void write(); ///< the field takes the focus
    void reply(std::int64_t comment); ///< what is written next answers this one, where it is there and somebody else's
    void clearDraft();             ///< and what is written next answers nothing
    QString draft() const;

signals:
    void seekAsked(double t_s);
    void addAsked(const QString& text); ///< at the moment that is shown
    void replyAsked(const QString& text, const chiron::desktop::NamedComment& to);

private:
    void buildDraft(QVBoxLayout& column);
    void buildList(QVBoxLayout& column);
    QString headOf(const NamedComment& comment, double t_s) const;
    QString authorOf(const NamedComment& comment) const;
    const NamedComment* chosen() const; ///< that may be answered; null: none
    void answer(const NamedComment* comment);
    void showReply();

    const Theme& m_theme;
    QLocale m_locale;
    MomentWords m_moments;
    double m_shown_s = 0.0;
    database::PersonId m_reader = 0;
    std::vector<NamedComment> m_comments; ///< as listed
    std::optional<NamedComment> m_replyTo;
    QListWidget* m_list;
    QLabel* m_none;
    QWidget* m_draft = nullptr;
    QPlainTextEdit* m_text = nullptr;
    QPushButton* m_add = nullptr;
    QPushButton* m_reviewed = nullptr;
    QPushButton* m_reply = nullptr;
    QPushButton* m_noReply = nullptr;
};

} // namespace chiron::desktop
