// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/playback/playback_data.h"
#include "desktop/theme/theme.h"

#include <QLocale>
#include <QWidget>
#include <functional>
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
    CommentPanel(const Theme& theme, const QLocale& locale, QWidget* parent = nullptr);

    /// `timeOf` gives the recording's time of a tick. In the order of time, those on the session as a whole first.
    void show(std::vector<NamedComment> comments, database::PersonId reader, const std::function<double(std::uint64_t)>& timeOf);
    void setMoment(double t_s); ///< where a new comment would go
    void setMayAdd(bool may);    ///< what the screen offers; what is permitted is checked where it is stored
    void setMayReview(bool may); ///< somebody else's session can be marked as reviewed without a remark
    bool mayAdd() const;
    void write(); ///< the field takes the focus
    void clearDraft();
    QString draft() const;

signals:
    void seekAsked(double t_s);
    void addAsked(const QString& text);

private:
    void buildDraft(QVBoxLayout& column);
    QString headOf(const NamedComment& comment, database::PersonId reader, double t_s) const;

    const Theme& m_theme;
    QLocale m_locale;
    QListWidget* m_list;
    QLabel* m_none;
    QWidget* m_draft = nullptr;
    QPlainTextEdit* m_text = nullptr;
    QPushButton* m_add = nullptr;
    QPushButton* m_reviewed = nullptr;
};

} // namespace chiron::desktop
