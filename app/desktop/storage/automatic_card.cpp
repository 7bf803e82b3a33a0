// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/storage/automatic_card.h"

#include "desktop/storage/storage_words.h"
#include "desktop/widgets/kit.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QSpinBox>

namespace chiron::desktop {

AutomaticCard::AutomaticCard(const Theme& theme, QWidget* parent) : QFrame(parent), m_theme(theme) {
    setProperty("kind", QStringLiteral("card"));
    auto* column = new QVBoxLayout(this);
    const int padding = theme.px(16);
    column->setContentsMargins(padding, padding, padding, padding);
    column->setSpacing(theme.px(10));
    column->addWidget(kit::label(theme, tr("Automatic backups"), TextStyle::title));
    column->addWidget(kit::label(theme,
                                 tr("Once a day, when nobody has used the program for a few minutes, or when "
                                    "it closes. A session or a study is "
                                    "never disturbed. Each backup is checked after it is made."),
                                 TextStyle::body, "muted"));
    m_notices = new QVBoxLayout;
    m_notices->setSpacing(theme.px(8));
    column->addLayout(m_notices);
    m_on = new QCheckBox(tr("Make a backup every day"));
    m_on->setObjectName(QStringLiteral("storage.automatic"));
    column->addWidget(m_on);
    auto* row = new QHBoxLayout;
    row->setSpacing(theme.px(10));
    auto* label = kit::label(theme, tr("Automatic backups to keep"), TextStyle::label);
    m_keep = new QSpinBox;
    m_keep->setObjectName(QStringLiteral("storage.keep"));
    m_keep->setAccessibleName(label->text());
    m_keep->setAccessibleDescription(
        tr("Older ones are removed. Backups that you made yourself are never removed."));
    m_keep->setToolTip(m_keep->accessibleDescription());
    m_keep->setRange(1, database::kMostBackupsKept);
    m_keep->setKeyboardTracking(false); // emits only completed input
    label->setBuddy(m_keep);
    label->setWordWrap(false);
    row->addWidget(label);
    row->addWidget(m_keep);
    row->addStretch();
    column->addLayout(row);
    column->addWidget(kit::label(theme, m_keep->accessibleDescription(), TextStyle::small, "muted"));
    connect(m_on, &QCheckBox::clicked, this, &AutomaticCard::choose);
    connect(m_keep, &QSpinBox::valueChanged, this, &AutomaticCard::choose);
}

void AutomaticCard::present(const database::BackupStanding& standing, bool onTheSitesDisk,
                            const QLocale& locale) {
    m_plan = standing.plan;
    {
        const QSignalBlocker quiet(m_keep);
        m_keep->setValue(m_plan.keep);
    }
    m_on->setChecked(m_plan.on);
    m_keep->setEnabled(m_plan.on);
    while (QLayoutItem* item = m_notices->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const auto add = [this](const StorageNotice& notice, const char* name) {
        auto* frame = kit::notice(m_theme, notice.kind, notice.text);
        frame->setObjectName(QLatin1String(name));
        m_notices->addWidget(frame);
    };
    add(StorageWords::automatic(standing, QDateTime::currentDateTimeUtc(), locale),
        "storage.automatic_notice");
    if (onTheSitesDisk)
        add(StorageWords::sameDisk(), "storage.same_disk");
}

void AutomaticCard::choose() {
    m_plan.on = m_on->isChecked();
    m_plan.keep = m_keep->value();
    m_keep->setEnabled(m_plan.on);
    emit planChosen(m_plan);
}

} // namespace chiron::desktop
