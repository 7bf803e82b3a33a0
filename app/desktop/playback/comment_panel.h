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

/// Comments on moments of the recording: a list that seeks to the chosen comment's moment, and a field for a
/// new comment on the moment that is shown.
/// Thread: GUI.
class CommentPanel : public QWidget {
    Q_OBJECT
public:
    CommentPanel(const Theme& theme, const QLocale& locale, MomentWords moments, QWidget* parent = nullptr);

    /// `timeOf` converts a tick into the recording's time. The list is in order of time, with comments on the
    /// whole session first. A reply belongs to the moment of the comment that it answers and stands below it.
    void show(std::vector<NamedComment> comments, database::PersonId reader,
              const std::function<double(std::uint64_t)>& timeOf);
    void setMoment(double t_s);  ///< the moment that a new comment refers to
    void setMayAdd(bool may);    ///< what the screen offers; permission is checked where comments are stored
    void setMayReview(bool may); ///< allows marking another person's session as reviewed without a comment
    bool mayAdd() const;
    void write(); ///< moves the focus to the text field
    /// Makes the next text a reply to this comment, if the comment exists and is by another person.
    void reply(std::int64_t comment);
    void clearDraft(); ///< also ends a reply
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
    const NamedComment* chosen() const; ///< a comment that may be answered; null if none
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
