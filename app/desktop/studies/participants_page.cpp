// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/participants_page.h"

#include "desktop/plots/fitted_table.h"
#include "desktop/studies/consent_dialog.h"
#include "desktop/studies/enrol_dialog.h"
#include "desktop/studies/key_table_dialog.h"
#include "desktop/studies/participant_progress.h"
#include "desktop/studies/study_words.h"
#include "desktop/studies/withdraw_dialog.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"

#include <algorithm>

namespace chiron::desktop {

namespace {
enum Column { codeColumn, stateColumn, progressColumn, orderColumn, enrolledColumn, consentColumn, columns };
constexpr int kMostRows = 12;
constexpr int kFewestRows = 4;
} // namespace

ParticipantsPage::ParticipantsPage(AppContext& app, const OpenStudy& study, const QString& selected,
                                   QWidget* parent)
    : QWidget(parent), m_app(app), m_study(study) {
    const Theme& theme = app.theme();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(12));
    if (study.editable()) {
        column->addWidget(
            kit::notice(theme, "info", tr("Participants can be enrolled once the design is frozen.")));
        column->addStretch();
        return;
    }
    column->addWidget(actions());
    if (study.participants.empty()) {
        column->addWidget(kit::label(
            theme,
            tr("Nobody is enrolled yet. Each participant gets a random code; the identity is kept in a "
               "separate key table."),
            TextStyle::body, "muted"));
    } else {
        m_table = new FittedTable(theme, columns);
        m_table->setObjectName(QStringLiteral("participants.table"));
        m_table->setAccessibleName(tr("Participants"));
        m_table->setHorizontalHeaderLabels(
            {tr("Code"), tr("State"), tr("Conditions"), tr("Design row"), tr("Enrolled"), tr("Consent")});
        m_table->horizontalHeaderItem(orderColumn)
            ->setToolTip(tr("The row of the order design (%1), counted from 1: it says in which order this "
                            "participant does the conditions. Whoever is enrolled gets the next free row, "
                            "and the row of somebody who withdraws becomes free again, so the rows need not "
                            "follow the order of enrolment.")
                             .arg(study_words::order(study.design.order)));
        fill(selected);
        connect(m_table, &QTableWidget::itemSelectionChanged, this, &ParticipantsPage::showActions);
        connect(m_table, &QTableWidget::itemSelectionChanged, this, &ParticipantsPage::showDetail);
        connect(m_table, &QTableWidget::itemSelectionChanged, this, [this] {
            if (const ParticipantRow* row = this->selected())
                emit selectedChanged(QString::fromStdString(row->participant.code));
        });
        connect(m_table, &QTableWidget::activated, this, &ParticipantsPage::run);
        column->addWidget(m_table);
        const kit::Box detail = kit::box(theme);
        const auto line = [&](const char* name, TextStyle style) {
            auto* words = kit::label(theme, {}, style);
            words->setObjectName(QLatin1String(name));
            detail.layout->addWidget(words);
            return words;
        };
        m_detailTitle = line("participants.detail.code", TextStyle::title);
        m_detail = line("participants.detail", TextStyle::body);
        m_next = line("participants.detail.next", TextStyle::strong);
        column->addWidget(detail.frame);
        showDetail();
    }
    column->addStretch();
    showActions();
}

QWidget* ParticipantsPage::actions() {
    const Theme& theme = m_app.theme();
    auto* bar = new QWidget;
    auto* row = new FlowLayout(theme.px(8), bar);
    const auto add = [&](const char* name, const QString& text, const char* kind, const char* icon,
                         void (ParticipantsPage::*act)()) {
        auto* button = kit::button(theme, text, kind, QLatin1String(icon));
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, act);
        row->addWidget(button);
        return button;
    };
    m_enrol = add("participants.enrol", tr("Enrol …"), "primary", "list-add-user", &ParticipantsPage::enrol);
    m_consent = add("participants.consent", tr("Consent …"), "", "document-edit", &ParticipantsPage::consent);
    m_run = add("participants.run", tr("Run"), "", "media-playback-start", &ParticipantsPage::run);
    m_withdraw =
        add("participants.withdraw", tr("Withdraw …"), "", "list-remove-user", &ParticipantsPage::withdraw);
    m_keys = add("participants.keys", tr("Who is who …"), "quiet", "view-certificate",
                 &ParticipantsPage::showKeys);
    const bool mayKnow =
        m_study.summary.author == m_app.actor().personId() || m_app.has(database::Role::admin);
    m_keys->setVisible(mayKnow);
    return bar;
}

void ParticipantsPage::showDetail() {
    const ParticipantRow* row = selected();
    if (!row)
        return;
    QStringList lines;
    for (const ConditionProgress& each : conditionProgress(m_study, *row))
        lines << tr("%1. %2: %3.")
                     .arg(m_app.locale().toString(lines.size() + 1),
                          conditionName(m_study, each.label, m_app.language()),
                          progressWords(m_study, each, m_app.locale()));
    m_detailTitle->setText(QString::fromStdString(row->participant.code));
    m_detail->setText(lines.join(QLatin1Char('\n')));
    m_next->setText(nextStepFor(m_study, *row, m_app.language()));
}

void ParticipantsPage::fill(const QString& selected) {
    const Theme& theme = m_app.theme();
    const QLocale locale = m_app.locale();
    m_table->setRowCount(static_cast<int>(m_study.participants.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const ParticipantRow& shown = m_study.participants[static_cast<std::size_t>(row)];
        const auto put = [&](int column, const QString& text) {
            auto* item = new QTableWidgetItem(text);
            m_table->setItem(row, column, item);
            return item;
        };
        put(codeColumn, QString::fromStdString(shown.participant.code))->setFont(theme.font(TextStyle::mono));
        const QString state = study_words::participantState(shown.participant.state);
        put(stateColumn, shown.participant.simulated ? tr("%1 (simulated)").arg(state) : state);
        put(progressColumn, participantProgress(m_study, shown, locale));
        put(orderColumn, locale.toString(shown.participant.order + 1))
            ->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        put(enrolledColumn, study_words::moment(shown.participant.enrolledUtc, locale));
        put(consentColumn, study_words::moment(shown.participant.consentUtc, locale));
    }
    m_table->setRowsSeen(std::clamp(m_table->rowCount(), kFewestRows, kMostRows));
    int at = 0;
    for (int row = 0; row < m_table->rowCount(); ++row)
        if (m_table->item(row, codeColumn)->text() == selected)
            at = row;
    m_table->selectRow(at);
    m_table->scrollToItem(m_table->item(at, codeColumn));
}

const ParticipantRow* ParticipantsPage::selected() const {
    const int row = m_table ? m_table->currentRow() : -1;
    return row >= 0 && row < static_cast<int>(m_study.participants.size())
               ? &m_study.participants[static_cast<std::size_t>(row)]
               : nullptr;
}

void ParticipantsPage::showActions() {
    using database::ParticipantState;
    const ParticipantRow* row = selected();
    const QString notAPerson = !row                         ? tr("Choose a participant in the list first.")
                               : row->participant.simulated ? tr("This participant is simulated.")
                                                            : QString();
    const auto state = row ? row->participant.state : ParticipantState::enrolled;
    const QString gone = notAPerson.isEmpty() && state == ParticipantState::withdrawn
                             ? tr("This participant has withdrawn.")
                             : notAPerson;
    const QString done = gone.isEmpty() && state == ParticipantState::completed
                             ? tr("This participant has done every run.")
                             : gone;
    const bool consented = done.isEmpty() && state == ParticipantState::consented;
    kit::allowUnless(*m_enrol, m_study.summary.state == database::StudyState::frozen
                                   ? QString()
                                   : tr("Participants can be enrolled only while the study is frozen."));
    kit::allowUnless(*m_consent, consented ? tr("The consent is recorded already.") : done);
    const bool asks = state == ParticipantState::completed && isWaiting(m_study, *row); // Run opens them
    kit::allowUnless(*m_run, asks                           ? QString()
                             : done.isEmpty() && !consented ? tr("Record the consent first.")
                                                            : done);
    kit::allowUnless(*m_withdraw, gone);
    kit::allowUnless(*m_keys, m_study.participants.empty() ? tr("Nobody is enrolled yet.") : QString());
}

void ParticipantsPage::enrol() {
    auto* dialog = new EnrolDialog(m_app, m_study, window()); // it outlives this page, which is rebuilt
    // This selects the new participant after the list is reloaded.
    connect(dialog, &EnrolDialog::enrolledAs, this, &ParticipantsPage::selectedChanged);
    connect(dialog, &EnrolDialog::changed, this, &ParticipantsPage::changed);
    emit enrolOpened(dialog);
    dialog->open();
}

void ParticipantsPage::consent() {
    if (const ParticipantRow* row = selected()) {
        auto* dialog = new ConsentDialog(m_app, m_study, row->participant, window());
        connect(dialog, &ConsentDialog::changed, this, &ParticipantsPage::changed);
        dialog->open();
    }
}

void ParticipantsPage::withdraw() {
    if (const ParticipantRow* row = selected()) {
        auto* dialog = new WithdrawDialog(m_app, row->participant, window());
        connect(dialog, &WithdrawDialog::changed, this, &ParticipantsPage::changed);
        dialog->open();
    }
}

void ParticipantsPage::showKeys() {
    (new KeyTableDialog(m_app, m_study.summary.id, this))->open();
}

void ParticipantsPage::run() {
    if (const ParticipantRow* row = selected())
        m_app.navigator().go(
            QStringLiteral("study_run"),
            {{QStringLiteral("study"), qlonglong(m_study.summary.id)},
             {QStringLiteral("participant"), QString::fromStdString(row->participant.code)}});
}

} // namespace chiron::desktop
