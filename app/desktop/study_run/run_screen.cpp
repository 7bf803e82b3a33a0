// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/run_screen.h"

#include "desktop/sound/sound_loader.h"
#include "desktop/studies/consent_dialog.h"
#include "desktop/studies/enrol_dialog.h"
#include "desktop/studies/participant_card.h"
#include "desktop/studies/participant_progress.h"
#include "desktop/studies/study_device.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"
#include "session/study/study_store.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

namespace chiron::desktop {

RunScreen::RunScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_study(place.parameters.value(QStringLiteral("study")).toLongLong()),
      m_participant(place.parameters.value(QStringLiteral("participant")).toString()) {
    if (place.parameters.value(QStringLiteral("just_ran")).toBool())
        m_finished = m_participant;
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_panel = new StatePanel(context.theme());
    column->addWidget(m_panel);
}

QString RunScreen::title() const {
    return tr("Run");
}

QString RunScreen::help() const {
    return tr("Takes a participant through a study.\n\nChoose the study and the participant's code. The "
              "conditions appear in the "
              "participant's own order; if the experimenter is blinded, they appear under sealed codes. The "
              "questionnaires before and "
              "after the runs are answered here, too, and those about a condition once it is done.\n\nAn "
              "interrupted run resumes at the trial where it stopped.");
}

void RunScreen::enter() {
    load();
}

void RunScreen::load() {
    m_heard.reset(); // headphones may have been connected
    m_panel->showLoading(
        tr("Reading the studies …"),
        readStudies(
            context(), this,
            [](database::StudyReader& reader) -> core::Result<std::vector<OpenStudy>> {
                auto list = reader.listStudies();
                CHIRON_TRY(list);
                std::vector<OpenStudy> studies;
                for (const database::StudySummary& summary : *list) {
                    if (summary.state != database::StudyState::frozen &&
                        summary.state != database::StudyState::closed)
                        continue;
                    auto open = openStudy(reader, summary.id);
                    CHIRON_TRY(open);
                    studies.push_back(std::move(*open));
                }
                return studies;
            },
            [this](core::Result<std::vector<OpenStudy>> studies) { loaded(std::move(studies)); }));
}

void RunScreen::loaded(core::Result<std::vector<OpenStudy>> studies) {
    if (!studies) {
        m_panel->showError(tr("The studies could not be read"), studies.error(), [this] { load(); });
        return;
    }
    m_studies = std::move(*studies);
    if (m_studies.empty()) {
        m_panel->showEmpty(tr("No study can be run yet"),
                           tr("A study can be run as soon as its design is frozen and participants are "
                              "enrolled."),
                           tr("Open the studies"),
                           [this] { context().navigator().go(QStringLiteral("studies")); });
        return;
    }
    if (!study())
        m_study = m_studies.back().summary.id;
    build();
    m_panel->showContent();
}

const OpenStudy* RunScreen::study() const {
    const auto found = std::find_if(m_studies.begin(), m_studies.end(),
                                    [this](const OpenStudy& each) { return each.summary.id == m_study; });
    return found == m_studies.end() ? nullptr : &*found;
}

const ParticipantRow* RunScreen::participant() const {
    const OpenStudy* open = study();
    if (!open)
        return nullptr;
    for (const ParticipantRow& row : open->participants)
        if (QString::fromStdString(row.participant.code) == m_participant)
            return &row;
    return nullptr;
}

void RunScreen::build() {
    auto* page = new ScrollPage(context().theme(), 900);
    page->column()->addWidget(kit::label(context().theme(), title(), TextStyle::heading));
    page->column()->addWidget(choiceBox());
    auto* holder = new QWidget;
    m_holder = new QVBoxLayout(holder);
    m_holder->setContentsMargins(0, 0, 0, 0);
    m_shown = nullptr;
    page->column()->addWidget(holder);
    page->column()->addStretch();
    delete m_panel->content();
    m_panel->setContent(page);
    showParticipant();
}

QWidget* RunScreen::choiceBox() {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    const auto add = [&](const QString& label, const char* name) {
        auto* field = new QComboBox;
        field->setObjectName(QLatin1String(name));
        field->setAccessibleName(label);
        field->setFont(theme.font(TextStyle::body));
        auto* words = kit::label(theme, label, TextStyle::label);
        words->setBuddy(field);
        box.layout->addWidget(words);
        box.layout->addWidget(field);
        return field;
    };
    m_studyChoice = add(tr("Study"), "run.study");
    for (const OpenStudy& each : m_studies)
        m_studyChoice->addItem(study_words::studyName(each.summary), qlonglong(each.summary.id));
    m_studyChoice->setCurrentIndex(m_studyChoice->findData(qlonglong(m_study)));
    m_participantChoice = add(tr("Participant, by code"), "run.participant");
    for (const ParticipantRow& row : study()->participants) {
        const QString code = QString::fromStdString(row.participant.code);
        if (!row.participant.simulated)
            m_participantChoice->addItem(
                tr("%1 · %2").arg(code, participantStanding(*study(), row, context().locale())), code);
    }
    selectWhoIsNext();
    const int wanted = m_participantChoice->findData(m_participant);
    m_participantChoice->setCurrentIndex(std::max(0, wanted));
    m_participant = m_participantChoice->currentData().toString();
    m_participantChoice->setEnabled(m_participantChoice->count() > 0);
    m_whoIsNext = kit::label(theme, {}, TextStyle::strong);
    m_whoIsNext->setObjectName(QStringLiteral("run.who_is_next"));
    box.layout->addWidget(m_whoIsNext);
    connect(m_studyChoice, &QComboBox::activated, this, [this] {
        m_study = m_studyChoice->currentData().toLongLong();
        m_participant.clear();
        m_finished.clear();
        QMetaObject::invokeMethod(this, &RunScreen::build, Qt::QueuedConnection);
    });
    connect(m_participantChoice, &QComboBox::activated, this, [this] {
        m_participant = m_participantChoice->currentData().toString();
        m_finished.clear();
        showParticipant();
    });
    return box.frame;
}

/// Whoever has something left to do stays selected.
void RunScreen::selectWhoIsNext() {
    const ParticipantRow* row = participant();
    if (m_participant.isEmpty()) {
        m_participant = nextWaiting();
    } else if (!m_finished.isEmpty() && row && isWaiting(*study(), *row)) {
        m_finished.clear();
    } else if (!m_finished.isEmpty()) {
        if (const QString next = nextWaiting(m_participant); !next.isEmpty())
            m_participant = next;
    }
}

QString RunScreen::whoIsNext() const {
    const ParticipantRow* row = participant();
    if (!row)
        return {};
    const auto after = [this](const QString& words) {
        return m_finished.isEmpty()
                   ? words
                   : tr("%1 has nothing left to do.").arg(m_finished) + QLatin1Char(' ') + words;
    };
    if (isWaiting(*study(), *row))
        return after(tr("%1 comes next and is selected.").arg(m_participant));
    const QString next = nextWaiting(m_participant);
    if (!next.isEmpty())
        return tr("%1 has nothing left to do. %2 comes next.").arg(m_participant, next);
    return study()->summary.state == database::StudyState::frozen
               ? tr("Nobody who is enrolled has anything left to do. Enrol the next participant.")
               : tr("Nobody who is enrolled has anything left to do.");
}

void RunScreen::showParticipant() {
    context().navigator().note(
        {{QStringLiteral("study"), qlonglong(m_study)}, {QStringLiteral("participant"), m_participant}});
    m_whoIsNext->setText(whoIsNext());
    m_whoIsNext->setVisible(!m_whoIsNext->text().isEmpty());
    delete m_shown;
    m_shown = new QWidget;
    auto* column = new QVBoxLayout(m_shown);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(context().theme().px(16));
    for (QWidget* notice : {shownNotice(), soundNotice()})
        if (notice)
            column->addWidget(notice);
    column->addWidget(participantBox());
    if (QWidget* left = leftBox())
        column->addWidget(left);
    m_holder->addWidget(m_shown);
}

/// Whoever has done everything needs no such notice any more.
QWidget* RunScreen::shownNotice() {
    const ParticipantRow* row = participant();
    const bool toCome = row && (row->participant.state == database::ParticipantState::enrolled ||
                                row->participant.state == database::ParticipantState::consented);
    if (!toCome || studyDeviceRendersForce())
        return nullptr;
    auto* notice = kit::notice(context().theme(), "info", shownOnlyWords());
    notice->setObjectName(QStringLiteral("run.shown"));
    return notice;
}

/// Shown here to the experimenter, because it does not belong on the participant's page.
QWidget* RunScreen::soundNotice() {
    const ParticipantRow* row = participant();
    if (!study()->design.trial.maskingSound || !row ||
        row->participant.state != database::ParticipantState::consented)
        return nullptr;
    if (!m_heard)
        m_heard = loadSound().output != nullptr;
    if (*m_heard)
        return nullptr;
    auto* notice = kit::notice(context().theme(), "warning",
                               tr("This study plays a masking sound, and this machine has no sound output: "
                                  "participants would hear the device. Connect "
                                  "headphones or loudspeakers and open this page again. You can also go on: "
                                  "each trial is then recorded as not masked."));
    notice->setObjectName(QStringLiteral("run.no_sound"));
    return notice;
}

QWidget* RunScreen::participantBox() {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    const OpenStudy& open = *study();
    const ParticipantRow* row = participant();
    if (!row) {
        box.layout->addWidget(kit::label(theme, tr("Nobody is enrolled yet."), TextStyle::title));
        addEnrol(*box.layout, true);
        return box.frame;
    }
    box.layout->addWidget(kit::label(theme, m_participant, TextStyle::heading));
    if (row->participant.state == database::ParticipantState::enrolled) {
        box.layout->addWidget(kit::notice(
            theme, "warning", tr("Consent is missing. Nothing can start before it is recorded.")));
        auto* consent =
            kit::button(theme, tr("Record the consent …"), "primary", QStringLiteral("document-edit"));
        consent->setObjectName(QStringLiteral("run.consent"));
        connect(consent, &QPushButton::clicked, this, [this, who = row->participant] { askConsent(who); });
        box.layout->addWidget(consent, 0, Qt::AlignLeft);
        return box.frame;
    }
    const std::vector<ConditionProgress> conditions = conditionProgress(open, *row);
    const auto toDo = std::find_if(conditions.begin(), conditions.end(), [](const ConditionProgress& each) {
        return each.state != ConditionProgress::State::done;
    });
    const bool offered = row->participant.state == database::ParticipantState::consented &&
                         toDo != conditions.end() && !toDo->closed;
    const bool asks = !offered && isWaiting(open, *row);
    bool answerNext = asks; // the first that is not answered
    const auto ask = [&](const Asked& asked) {
        const bool next = answerNext && !isAnswered(*row, asked);
        box.layout->addWidget(questionnaireRow(*row, asked, next));
        answerNext = answerNext && !next;
    };
    using When = psychophysics::Questionnaire::When;
    const auto questionnaires = [&](When when) {
        for (const psychophysics::Questionnaire& each : open.design.questionnaires)
            if (each.when == when)
                ask({each});
    };
    // These are offered to participants who were enrolled without them.
    for (const psychophysics::Questionnaire& each : open.design.questionnaires)
        if (each.when == When::enrolment && !isAnswered(*row, {each}))
            ask({each});
    questionnaires(When::before);
    if (const QString sequence = sequenceWords(open.design, context().locale());
        offered && !sequence.isEmpty()) {
        auto* words =
            kit::label(theme, tr("Sequence in each condition: %1.").arg(sequence), TextStyle::small, "muted");
        words->setObjectName(QStringLiteral("run.sequence"));
        box.layout->addWidget(words);
    }
    int position = 0;
    for (const ConditionProgress& progress : conditions) {
        box.layout->addWidget(conditionRow(*row, position, progress, offered && &progress == &*toDo));
        const auto run =
            std::find_if(row->runs.begin(), row->runs.end(), [&](const database::StudyRun& each) {
                return session::labelOf(each) == progress.label &&
                       each.state == database::StudyRunState::completed;
            });
        // These are asked only after the condition is completed.
        for (const psychophysics::Questionnaire& each : open.design.questionnaires)
            if (each.when == When::afterCondition && run != row->runs.end())
                ask({each, &*run, position});
        ++position;
    }
    questionnaires(When::after);
    if (!offered) { // always offers a next step
        auto* step = kit::label(theme, nextStepFor(open, *row, context().language()), TextStyle::body);
        step->setObjectName(QStringLiteral("run.next_step"));
        box.layout->addWidget(step);
    }
    addOthers(*box.layout, !offered && !asks);
    return box.frame;
}

void RunScreen::addOthers(QVBoxLayout& layout, bool first) {
    const ParticipantRow* row = participant();
    const bool brokeOff = !first && row && !row->left.empty();
    if (brokeOff) {
        auto* words =
            kit::label(context().theme(),
                       tr("If %1 does not come back, go on with somebody else. The trials that were "
                          "done are kept, and count if they suffice for a value. The run can be "
                          "resumed later. To take %1 out of the study, withdraw them on the "
                          "study's page of participants.")
                           .arg(m_participant),
                       TextStyle::small, "muted");
        words->setObjectName(QStringLiteral("run.broke_off"));
        layout.addWidget(words);
    }
    const QString waiting = first || brokeOff ? nextWaiting(m_participant) : QString();
    if (!waiting.isEmpty()) {
        auto* go = kit::button(context().theme(), tr("Go on with %1").arg(waiting), first ? "primary" : "",
                               QStringLiteral("go-next"));
        go->setObjectName(first ? QStringLiteral("run.next") : QStringLiteral("run.instead"));
        // Queued, because the button goes with the participant who is shown.
        connect(
            go, &QPushButton::clicked, this, [this, waiting] { goOnWith(waiting); }, Qt::QueuedConnection);
        layout.addWidget(go, 0, Qt::AlignLeft);
    }
    addEnrol(layout, first && waiting.isEmpty());
}

void RunScreen::goOnWith(const QString& participant) {
    m_finished.clear();
    m_participant = participant;
    m_participantChoice->setCurrentIndex(m_participantChoice->findData(participant));
    m_participantChoice->setFocus(Qt::OtherFocusReason);
    showParticipant();
}

/// Enrolling the next participant must be possible here, without going to another page.
void RunScreen::addEnrol(QVBoxLayout& layout, bool first) {
    if (study()->summary.state != database::StudyState::frozen)
        return; // a closed study accepts no participants
    auto* button = kit::button(context().theme(),
                               participant() ? tr("Enrol the next participant …") : tr("Enrol somebody …"),
                               first ? "primary" : "", QStringLiteral("list-add-user"));
    button->setObjectName(QStringLiteral("run.enrol"));
    connect(button, &QPushButton::clicked, this, &RunScreen::enrol);
    layout.addWidget(button, 0, Qt::AlignLeft);
}

void RunScreen::enrol() {
    auto* dialog = new EnrolDialog(context(), *study(), window());
    connect(dialog, &EnrolDialog::enrolledAs, this, [this](const QString& code) { m_participant = code; });
    connect(dialog, &EnrolDialog::changed, this, &RunScreen::load);
    connect(dialog, &EnrolDialog::consentAsked, this, &RunScreen::askConsent);
    dialog->open();
}

void RunScreen::askConsent(const database::Participant& participant) {
    auto* dialog = new ConsentDialog(context(), *study(), participant, window());
    connect(dialog, &ConsentDialog::changed, this, &RunScreen::load);
    dialog->open();
}

QWidget* RunScreen::conditionRow(const ParticipantRow& row, int position, const ConditionProgress& progress,
                                 bool next) {
    const Theme& theme = context().theme();
    const OpenStudy& open = *study();
    const kit::Box box = kit::box(theme, "raised");
    auto* line = new QHBoxLayout;
    const std::string& label = progress.label;
    const QString name = conditionName(open, label, context().language());
    // The texts are stacked, because side by side a text about an interruption would wrap into four lines.
    auto* said = new QVBoxLayout;
    said->setSpacing(theme.px(2));
    line->addLayout(said, 1);
    said->addWidget(kit::label(theme, tr("%1. %2").arg(context().locale().toString(position + 1), name),
                               TextStyle::strong));
    const QString state = progressWords(open, progress, context().locale());
    const database::StudyRun* interrupted = nullptr;
    for (const database::StudyRun& run : row.runs)
        if (session::labelOf(run) == label && run.state == database::StudyRunState::open)
            interrupted = &run;
    auto* words = kit::label(theme, state, TextStyle::body, interrupted ? "warning" : "muted");
    words->setObjectName(QStringLiteral("run.state.%1").arg(position));
    said->addWidget(words);
    QVBoxLayout* cell = buttonCell(*line);
    if (next) {
        QPushButton* go =
            interrupted ? resumeButton(m_participant, *interrupted)
                        : kit::button(theme, tr("Begin"), "primary", QStringLiteral("media-playback-start"));
        go->setObjectName(QStringLiteral("run.begin"));
        if (!interrupted) {
            go->setAccessibleName(tr("Begin %1").arg(name));
            connect(go, &QPushButton::clicked, this, [this, label] { run(label); });
        }
        cell->addWidget(go, 0, Qt::AlignRight);
    }
    box.layout->addLayout(line);
    return box.frame;
}

bool RunScreen::isAnswered(const ParticipantRow& row, const Asked& asked) const {
    return asked.run ? study()->answeredAfter.contains({asked.run->id, asked.questionnaire.id})
                     : study()->answered.contains({row.participant.id, asked.questionnaire.id});
}

QWidget* RunScreen::questionnaireRow(const ParticipantRow& row, const Asked& asked, bool next) {
    const auto& [questionnaire, run, position] = asked;
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme, "raised");
    auto* line = new QHBoxLayout;
    const QString title = study_words::text(questionnaire.title, context().language());
    const QString name =
        run ? tr("%1, about condition %2").arg(title, context().locale().toString(position + 1)) : title;
    auto* said = new QVBoxLayout;
    said->setSpacing(theme.px(2));
    line->addLayout(said, 1);
    said->addWidget(kit::label(theme, name, TextStyle::strong));
    const bool done = isAnswered(row, asked);
    said->addWidget(
        kit::label(theme, done ? tr("answered") : tr("not answered yet"), TextStyle::body, "muted"));
    QVBoxLayout* cell = buttonCell(*line);
    if (!done && row.participant.state != database::ParticipantState::withdrawn) {
        auto* go = kit::button(theme, tr("Answer"), next ? "primary" : "", QStringLiteral("document-edit"));
        go->setObjectName(
            QStringLiteral("run.questionnaire.%1").arg(QString::fromStdString(questionnaire.id)) +
            (run ? QStringLiteral(".%1").arg(position) : QString()));
        go->setAccessibleName(tr("Answer %1").arg(name));
        connect(go, &QPushButton::clicked, this, [this, id = questionnaire.id, number = run ? run->id : 0] {
            QVariantMap place{{QStringLiteral("study"), qlonglong(m_study)},
                              {QStringLiteral("participant"), m_participant},
                              {QStringLiteral("questionnaire"), QString::fromStdString(id)}};
            if (number != 0)
                place.insert(QStringLiteral("run"), qlonglong(number));
            context().navigator().go(QStringLiteral("questionnaire"), place);
        });
        cell->addWidget(go, 0, Qt::AlignRight);
    }
    box.layout->addLayout(line);
    return box.frame;
}

void RunScreen::run(const std::string& condition) {
    context().navigator().go(QStringLiteral("study_trials"),
                             {{QStringLiteral("study"), qlonglong(m_study)},
                              {QStringLiteral("participant"), m_participant},
                              {QStringLiteral("condition"), QString::fromStdString(condition)}});
}

} // namespace chiron::desktop
