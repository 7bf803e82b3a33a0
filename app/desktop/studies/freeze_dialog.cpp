// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/freeze_dialog.h"

#include "desktop/studies/check_list.h"
#include "desktop/studies/study_jobs.h"
#include "desktop/widgets/kit.h"

#include <QCheckBox>

namespace chiron::desktop {

namespace {

/// In groups of eight digits, so that it can wrap and be compared.
QString grouped(const std::string& sha256) {
    QStringList groups;
    for (std::size_t i = 0; i < sha256.size(); i += 8)
        groups << QString::fromStdString(sha256.substr(i, 8));
    return groups.join(QLatin1Char(' '));
}

} // namespace

FreezeDialog::FreezeDialog(AppContext& context, const database::StudySummary& study,
                           const psychophysics::StudyDesign& design, const FreezeFacts& facts,
                           QWidget* parent)
    : FormDialog(context, QStringLiteral("freeze"), tr("Freeze %1").arg(QString::fromStdString(study.title)),
                 parent),
      m_study(study.id) {
    m_checks = new CheckList(context, design, facts);
    column()->addWidget(m_checks);
    connect(m_checks, &CheckList::goAsked, this, [this](const FreezeCheck& check) {
        emit goAsked(check);
        reject();
    });
    m_cannot = kit::notice(
        theme(), "bad",
        tr("What is marked in red must be corrected first: after freezing, nobody can change it."));
    m_cannot->setObjectName(QStringLiteral("freeze.cannot"));
    column()->addWidget(m_cannot);
    m_seen = new QCheckBox(tr("I have seen the points that are worth a look and freeze the design anyway"));
    m_seen->setObjectName(QStringLiteral("freeze.seen"));
    m_seen->setFont(theme().font(TextStyle::body));
    // The row stands above the buttons, visible however long the list is.
    auto* outside = static_cast<QVBoxLayout*>(layout());
    auto* row = new QHBoxLayout;
    row->setContentsMargins(theme().px(24), 0, theme().px(24), theme().px(10));
    row->addWidget(m_seen);
    outside->insertLayout(outside->count() - 1, row);
    column()->addWidget(kit::label(
        theme(), tr("From now on nobody can change the design. Participants can be enrolled, each condition "
                    "gets a sealed code, and every export carries this SHA-256 of the design:")));
    auto* sha =
        kit::label(theme(), grouped(catalogue::studySha256(catalogue::studyJson(design))), TextStyle::mono);
    sha->setObjectName(QStringLiteral("freeze.sha256"));
    sha->setTextInteractionFlags(Qt::TextSelectableByMouse);
    const kit::Box box = kit::box(theme(), "raised");
    box.layout->addWidget(sha);
    column()->addWidget(box.frame);
    column()->addWidget(kit::label(
        theme(),
        tr("%n condition(s)", nullptr, static_cast<int>(design.conditions.size())) + QStringLiteral(", ") +
            tr("%n participant(s) planned", nullptr, design.participantsPlanned),
        TextStyle::body, "muted"));
    column()->addWidget(kit::notice(
        theme(), "warning", tr("This cannot be undone. To change the study later, copy it into a new one.")));
    setAccept(tr("Freeze the design"));
    cancelAtEnter();
    connect(m_checks, &CheckList::changed, this, &FreezeDialog::weigh);
    connect(m_seen, &QCheckBox::toggled, this, &FreezeDialog::weigh);
    weigh();
}

void FreezeDialog::weigh() {
    const bool bad = m_checks->has(FreezeCheck::State::bad);
    const bool advice = m_checks->has(FreezeCheck::State::advice);
    m_cannot->setVisible(bad);
    m_seen->setVisible(advice && !bad);
    const QString whyNot = whyNotFrozen(m_checks->checks(), m_seen->isChecked());
    setAcceptable(whyNot.isEmpty(), whyNot);
}

void FreezeDialog::submit() {
    setWorking(true);
    writeStudies(
        context(), this,
        [study = m_study](database::StudyRepository& studies) { return studies.freezeStudy(study); },
        [this](const core::Result<std::string>& sha) {
            setWorking(false);
            if (!sha) {
                say("bad", tr("The study could not be frozen.\n%1").arg(inWords(sha.error())));
                return;
            }
            context().messages().done(tr("Frozen. Participants can be enrolled now."));
            emit frozen();
            accept();
        });
}

} // namespace chiron::desktop
