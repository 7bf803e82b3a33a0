// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/mark_list.h"

#include "desktop/playback/mark_look.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/wrapped_items.h"
#include "session_report/mark_words.h"

#include <QCheckBox>
#include <QLabel>
#include <QListWidget>

namespace chiron::desktop {

MarkList::MarkList(const Theme& theme, const QLocale& locale, std::vector<session::PlaybackMark> marks,
                   const std::string& exercise, MomentWords moments, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(locale), m_marks(std::move(marks)), m_exercise(exercise),
      m_moments(std::move(moments)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, theme.px(8), 0, 0);
    column->setSpacing(theme.px(6));
    m_penaltiesOnly = new QCheckBox(tr("Penalties only"));
    m_penaltiesOnly->setObjectName(QStringLiteral("playback.penalties_only"));
    m_contacts = new QCheckBox(tr("Include contacts"));
    m_contacts->setObjectName(QStringLiteral("playback.contacts"));
    m_list = new QListWidget;
    m_list->setObjectName(QStringLiteral("playback.marks"));
    m_list->setAccessibleName(tr("Events"));
    wrapItems(*m_list, theme);
    m_list->setIconSize(QSize(theme.px(18), theme.px(18)));
    m_none = kit::label(theme, tr("No events of this kind."), TextStyle::body, "muted");
    auto* filters = new ResponsiveRow(theme.px(260), theme.px(2));
    filters->add(m_penaltiesOnly);
    filters->add(m_contacts);
    column->addWidget(filters);
    column->addWidget(m_none);
    column->addWidget(m_list, 1);
    connect(m_penaltiesOnly, &QCheckBox::toggled, this, &MarkList::fill);
    connect(m_contacts, &QCheckBox::toggled, this, &MarkList::fill);
    const auto jump = [this](const QListWidgetItem* item) {
        if (item)
            emit seekAsked(item->data(Qt::UserRole).toDouble());
    };
    connect(m_list, &QListWidget::itemClicked, this, jump);
    connect(m_list, &QListWidget::currentItemChanged, this, jump);
    connect(m_list, &QListWidget::itemActivated, this, jump);
    fill();
}

void MarkList::fill() {
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const session::PlaybackMark& mark : m_marks) {
        if (m_penaltiesOnly->isChecked() && !session::isPenalty(mark.kind))
            continue;
        if (mark.kind == session::mark_kinds::kContact && !m_contacts->isChecked())
            continue;
        auto* item = new QListWidgetItem(
            m_theme.icon(markIcon(mark), markColour(mark.kind)),
            tr("%1  %2").arg(m_moments.at(mark.t_s), session_report::markText(mark, m_exercise, m_locale)));
        item->setData(Qt::UserRole, mark.t_s);
        m_list->addItem(item);
    }
    m_none->setVisible(m_list->count() == 0);
}

} // namespace chiron::desktop
