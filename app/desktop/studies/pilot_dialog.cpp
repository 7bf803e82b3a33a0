// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/pilot_dialog.h"

#include "desktop/accounts/form.h"
#include "desktop/frame/app_context.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "session/study/pilot_run.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>

namespace chiron::desktop {

PilotDialog::PilotDialog(AppContext& context, const psychophysics::StudyDesign& draft, qlonglong study,
                         QWidget* parent)
    : FormDialog(context, QStringLiteral("pilot"), tr("Pilot run"), parent), m_draft(draft), m_study(study),
      m_language(draft.consent.contains(context.language().toStdString()) ? context.language()
                                                                          : QStringLiteral("en")) {
    column()->addWidget(
        kit::label(theme(), tr("The design is tried exactly as it is now. The run is marked as a pilot and "
                               "never analysed with the study's data. Stop whenever you have seen enough.")));
    m_condition = new QComboBox;
    m_condition->setObjectName(QStringLiteral("pilot.condition"));
    m_condition->setAccessibleName(tr("Condition"));
    m_condition->setFont(theme().font(TextStyle::body));
    for (const psychophysics::Condition& each : draft.conditions)
        m_condition->addItem(study_words::text(each.title, context.language()),
                             QString::fromStdString(each.id));
    if (m_condition->count() > 1) {
        column()->addWidget(kit::label(theme(), tr("Condition"), TextStyle::label));
        column()->addWidget(m_condition);
    }
    m_who = form::textField(theme(), column(), tr("Who tries it (may be left empty)"),
                            QStringLiteral("pilot.who"));
    const kit::Box box = kit::box(theme(), "raised");
    auto* consent = kit::label(theme(), study_words::text(draft.consent, m_language));
    consent->setObjectName(QStringLiteral("pilot.consent"));
    box.layout->addWidget(consent);
    column()->addWidget(box.frame);
    m_agreed = new QCheckBox(tr("Whoever tries it has read this and agrees"));
    m_agreed->setObjectName(QStringLiteral("pilot.agreed"));
    m_agreed->setFont(theme().font(TextStyle::body));
    column()->addWidget(m_agreed);
    setAccept(tr("Begin the pilot"));
    const auto weigh = [this] {
        setAcceptable(m_agreed->isChecked(), tr("Tick the box first: whoever tries it must agree."));
    };
    connect(m_agreed, &QCheckBox::toggled, this, weigh);
    weigh();
    m_agreed->setFocus();
}

void PilotDialog::submit() {
    setWorking(true);
    context().background().run(
        this,
        [&database = context().site().database(), actor = context().actor(), draft = m_draft,
         who = m_who->text().trimmed().toStdString(), language = m_language.toStdString()](WorkToken&) {
            return session::beginPilot(database, actor, draft, who, language);
        },
        [this,
         condition = m_condition->currentData().toString()](const core::Result<session::PilotRun>& pilot) {
            setWorking(false);
            if (!pilot) {
                say("bad", tr("The pilot could not begin.\n%1").arg(inWords(pilot.error())));
                return;
            }
            const QVariantMap where{
                {QStringLiteral("study"), qlonglong(pilot->study)},
                {QStringLiteral("participant"), QString::fromStdString(pilot->participantCode)},
                {QStringLiteral("condition"), condition},
                {QStringLiteral("pilot_of"), m_study}};
            accept();
            context().navigator().go(QStringLiteral("study_trials"), where);
        });
}

} // namespace chiron::desktop
