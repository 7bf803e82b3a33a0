// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/comment_panel.h"

#include "desktop/widgets/kit.h"
#include "desktop/widgets/wrapped_items.h"

#include <QDateTime>
#include <QListWidget>
#include <QPlainTextEdit>
#include <algorithm>

namespace chiron::desktop {

CommentPanel::CommentPanel(const Theme& theme, const QLocale& locale, MomentWords moments, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(locale), m_moments(std::move(moments)),
      m_list(new QListWidget) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, theme.px(8), 0, 0);
    column->setSpacing(theme.px(6));
    buildDraft(*column);
    buildList(*column);
}

void CommentPanel::buildList(QVBoxLayout& column) {
    m_list->setObjectName(QStringLiteral("playback.comments"));
    m_list->setAccessibleName(tr("Comments"));
    wrapItems(*m_list, m_theme);
    m_list->setIconSize(QSize(m_theme.px(18), m_theme.px(18)));
    m_none = kit::label(m_theme, tr("No comments yet."), TextStyle::body, "muted");
    column.addWidget(m_none);
    column.addWidget(m_list, 1);
    m_reply = kit::button(m_theme, tr("Reply"), "", QStringLiteral("edit-comment"));
    m_reply->setObjectName(QStringLiteral("playback.comment_reply"));
    m_reply->hide();
    column.addWidget(m_reply, 0, Qt::AlignLeft);
    connect(m_reply, &QPushButton::clicked, this, [this] { answer(chosen()); });
    const auto jump = [this](const QListWidgetItem* item) {
        m_reply->setVisible(chosen());
        if (item && item->data(Qt::UserRole).isValid())
            emit seekAsked(item->data(Qt::UserRole).toDouble());
    };
    connect(m_list, &QListWidget::itemClicked, this, jump);
    connect(m_list, &QListWidget::currentItemChanged, this, jump);
}

void CommentPanel::buildDraft(QVBoxLayout& column) {
    m_draft = new QWidget;
    auto* inner = new QVBoxLayout(m_draft);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(m_theme.px(6));
    m_text = new QPlainTextEdit;
    m_text->setObjectName(QStringLiteral("playback.comment_text"));
    m_text->setAccessibleName(tr("New comment"));
    m_text->setPlaceholderText(tr("What do you see here?"));
    m_text->setTabChangesFocus(true);
    m_text->setFixedHeight(m_theme.px(56));
    m_add = kit::button(m_theme, {}, "", QStringLiteral("edit-comment"));
    m_add->setObjectName(QStringLiteral("playback.comment_add"));
    m_add->setEnabled(false);
    m_reviewed =
        kit::button(m_theme, tr("Reviewed, nothing to add"), "quiet", QStringLiteral("dialog-ok-apply"));
    m_reviewed->setObjectName(QStringLiteral("playback.reviewed"));
    m_reviewed->hide();
    inner->addWidget(m_text);
    m_noReply = kit::button(m_theme, tr("Do not reply"), "quiet");
    m_noReply->setObjectName(QStringLiteral("playback.comment_no_reply"));
    m_noReply->hide();
    inner->addWidget(m_add);
    inner->addWidget(m_noReply);
    inner->addWidget(m_reviewed);
    column.addWidget(m_draft);
    connect(m_text, &QPlainTextEdit::textChanged, this, [this] { m_add->setEnabled(!draft().isEmpty()); });
    connect(m_add, &QPushButton::clicked, this, [this] {
        if (m_replyTo)
            emit replyAsked(draft(), *m_replyTo);
        else
            emit addAsked(draft());
    });
    connect(m_noReply, &QPushButton::clicked, this, [this] { answer(nullptr); });
    connect(m_reviewed, &QPushButton::clicked, this,
            [this] { emit addAsked(tr("Reviewed. Nothing to add.")); });
    setMoment(0.0);
}

QString CommentPanel::draft() const {
    return m_text->toPlainText().trimmed();
}

bool CommentPanel::mayAdd() const {
    return !m_draft->isHidden();
}

void CommentPanel::write() {
    m_text->setFocus(Qt::ShortcutFocusReason);
}

void CommentPanel::clearDraft() {
    // The focus moves first, because the pressed button is disabled once the text is empty, and the page
    // would follow the focus.
    m_text->setFocus(Qt::OtherFocusReason);
    m_text->clear();
    m_replyTo.reset();
    showReply();
}

void CommentPanel::setMoment(double t_s) {
    m_shown_s = t_s;
    showReply();
}

void CommentPanel::showReply() {
    m_noReply->setVisible(m_replyTo.has_value());
    m_add->setText(m_replyTo ? tr("Reply to %1").arg(authorOf(*m_replyTo))
                             : tr("Comment here: %1").arg(m_moments.at(m_shown_s)));
}

const NamedComment* CommentPanel::chosen() const {
    const int row = m_list->currentRow();
    if (!mayAdd() || row < 0 || row >= static_cast<int>(m_comments.size()))
        return nullptr;
    const NamedComment& comment = m_comments[static_cast<std::size_t>(row)];
    return comment.comment.author == m_reader ? nullptr : &comment;
}

void CommentPanel::answer(const NamedComment* comment) {
    m_replyTo = comment ? std::optional(*comment) : std::nullopt;
    m_text->setFocus(Qt::OtherFocusReason);
    showReply();
}

void CommentPanel::reply(std::int64_t comment) {
    for (std::size_t row = 0; row < m_comments.size(); ++row)
        if (m_comments[row].comment.id == comment) {
            m_list->setCurrentRow(static_cast<int>(row));
            answer(chosen());
        }
}

void CommentPanel::setMayReview(bool may) {
    m_reviewed->setVisible(may);
}

void CommentPanel::setMayAdd(bool may) {
    m_draft->setVisible(may);
}

QString CommentPanel::authorOf(const NamedComment& comment) const {
    return comment.comment.author == m_reader ? tr("You")
           : comment.author.empty()           ? tr("Somebody else")
                                              : QString::fromStdString(comment.author);
}

QString CommentPanel::headOf(const NamedComment& comment, double t_s) const {
    const QDateTime utc =
        QDateTime::fromString(QString::fromStdString(comment.comment.utc), Qt::ISODateWithMs);
    const QString when = m_locale.toString(utc.toLocalTime().date(), QLocale::ShortFormat);
    return comment.comment.tick ? tr("%1 · %2 · %3").arg(m_moments.at(t_s), authorOf(comment), when)
                                : tr("Whole session · %1 · %2").arg(authorOf(comment), when);
}

void CommentPanel::show(std::vector<NamedComment> comments, database::PersonId reader,
                        const std::function<double(std::uint64_t)>& timeOf) {
    std::stable_sort(comments.begin(), comments.end(), [](const NamedComment& a, const NamedComment& b) {
        return a.comment.tick < b.comment.tick;
    });
    m_reader = reader;
    m_comments = std::move(comments);
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const NamedComment& named : m_comments) {
        const double t_s = named.comment.tick ? timeOf(*named.comment.tick) : 0.0;
        const QString text =
            named.comment.text.empty() ? tr("(erased)") : QString::fromStdString(named.comment.text);
        auto* item = new QListWidgetItem(m_theme.icon(QStringLiteral("edit-comment"), Colour::warning),
                                         QStringLiteral("%1\n%2").arg(headOf(named, t_s), text));
        if (named.comment.tick)
            item->setData(Qt::UserRole, t_s);
        m_list->addItem(item);
    }
    m_none->setVisible(m_list->count() == 0);
    m_reply->hide();
}

} // namespace chiron::desktop
