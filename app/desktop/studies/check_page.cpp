// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/check_page.h"

#include "desktop/frame/app_context.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"

namespace chiron::desktop {

CheckPage::CheckPage(const DesignPage& page, const OpenStudy& study, const std::vector<DesignFault>& faults,
                     QWidget* parent)
    : QWidget(parent), m_page(page), m_study(study) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(page.app.theme().px(16));
    column->addWidget(checksBox(faults));
    column->addWidget(pilotBox());
    if (!page.readOnly)
        column->addWidget(freezeBox());
    column->addStretch();
}

QWidget* CheckPage::checksBox(const std::vector<DesignFault>& faults) {
    const kit::Box box = titledBox(m_page.app.theme(), tr("Before you freeze"));
    auto* list =
        new CheckList(m_page.app, m_page.draft.design(), {faults, std::nullopt, pilotsTried(m_study)});
    connect(list, &CheckList::goAsked, this, &CheckPage::goAsked);
    box.layout->addWidget(list);
    return box.frame;
}

QWidget* CheckPage::pilotBox() {
    const Theme& theme = m_page.app.theme();
    const QLocale locale = m_page.app.locale();
    const kit::Box box = titledBox(theme, tr("Pilot runs"));
    box.layout->addWidget(kit::label(theme,
                                     tr("Somebody tries the design as it is now, with the real trials on "
                                        "this station. A pilot is kept apart: it is never "
                                        "analysed or exported with the study's data."),
                                     TextStyle::body, "muted"));
    for (const PilotRow& pilot : m_study.pilots) {
        QStringList words{study_words::moment(pilot.summary.createdUtc, locale),
                          tr("%n trial(s) that count", nullptr, pilot.scored)};
        if (pilot.spoiled > 0)
            words << tr("%n repeated", nullptr, pilot.spoiled);
        if (pilot.scored > 0)
            words << tr("%1 s per trial").arg(study_words::number(pilot.secondsPerTrial, locale, 2));
        auto* line = kit::label(theme, words.join(QStringLiteral(" · ")));
        line->setObjectName(QStringLiteral("check.pilot.row"));
        box.layout->addWidget(line);
    }
    if (!m_page.readOnly) {
        auto* go = kit::button(theme, tr("Pilot run …"), "", QStringLiteral("media-playback-start"));
        go->setObjectName(QStringLiteral("check.pilot"));
        connect(go, &QPushButton::clicked, this, &CheckPage::pilotAsked);
        box.layout->addWidget(go, 0, Qt::AlignLeft);
    }
    return box.frame;
}

QWidget* CheckPage::freezeBox() {
    const Theme& theme = m_page.app.theme();
    const kit::Box box = titledBox(theme, tr("Freeze"));
    box.layout->addWidget(
        kit::label(theme,
                   tr("Freezing is final: nobody can change the design afterwards, and every result can be "
                      "traced to it. Participants can "
                      "be enrolled from then on. To change something later, copy the study into a new one."),
                   TextStyle::body, "muted"));
    auto* go = kit::button(theme, tr("Freeze …"), "primary", QStringLiteral("object-locked"));
    go->setObjectName(QStringLiteral("check.freeze"));
    connect(go, &QPushButton::clicked, this, &CheckPage::freezeAsked);
    box.layout->addWidget(go, 0, Qt::AlignLeft);
    return box.frame;
}

} // namespace chiron::desktop
