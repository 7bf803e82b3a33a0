// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/study_screen.h"

#include "desktop/accounts/notice_area.h"
#include "desktop/frame/interface_language.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/studies/check_page.h"
#include "desktop/studies/conditions_page.h"
#include "desktop/studies/consent_dialog.h"
#include "desktop/studies/enrol_dialog.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/general_page.h"
#include "desktop/studies/participant_card.h"
#include "desktop/studies/participant_sentences.h"
#include "desktop/studies/participants_page.h"
#include "desktop/studies/preview_page.h"
#include "desktop/studies/questionnaires_page.h"
#include "desktop/studies/rules_page.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QTabBar>
#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr int kCheck_ms = 300;
constexpr double kBeside_px = 800; // total width of page and card
} // namespace

StudyScreen::StudyScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_study(place.parameters.value(QStringLiteral("study")).toLongLong()),
      m_tab(place.parameters.value(QStringLiteral("tab"), -1).toInt()),
      m_condition(place.parameters.value(QStringLiteral("condition")).toInt()),
      m_participant(place.parameters.value(QStringLiteral("participant")).toString()),
      m_language(QStringLiteral("en")) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_panel = new StatePanel(context.theme());
    column->addWidget(m_panel);
    m_check.setSingleShot(true);
    m_check.setInterval(kCheck_ms);
    connect(&m_check, &QTimer::timeout, this, &StudyScreen::check);
    connect(&m_draft, &StudyDraft::changed, this, &StudyScreen::changed);
    // The stack counts a step only after it is done.
    connect(&m_draft.history(), &QUndoStack::indexChanged, this, &StudyScreen::showState);
    // The form that requested this may be gone by then.
    connect(&m_draft, &StudyDraft::structureChanged, this, &StudyScreen::showPage, Qt::QueuedConnection);
}

QString StudyScreen::title() const {
    const QString name = QString::fromStdString(m_open.summary.title);
    return name.isEmpty() ? tr("Study") : name;
}

QString StudyScreen::help() const {
    return tr("One study. While it is a draft, you can change everything. Go through the pages with Next and "
              "Back, or jump to one by its "
              "name. Complete entries are saved at once, Ctrl+Z undoes a step, and what is wrong is said "
              "under its field. Beside the pages "
              "stands what a participant will meet.\n\nConditions defines what is compared, with which task "
              "and procedure. Preview runs the "
              "study with simulated observers and shows the expected precision, number of trials and time. "
              "Check and freeze says what is "
              "missing, lets somebody try the design as a pilot, and freezes it permanently under its "
              "SHA-256; participants can be enrolled "
              "from then on, under random codes, with their consent.");
}

void StudyScreen::enter() {
    load();
}

void StudyScreen::load() {
    m_panel->showLoading(
        tr("Reading the study …"),
        readStudies(
            context(), this,
            [study = m_study](database::StudyReader& reader) { return openStudy(reader, study); },
            [this](core::Result<OpenStudy> study) { loaded(std::move(study)); }));
}

void StudyScreen::loaded(core::Result<OpenStudy> study) {
    if (!study) {
        m_panel->showError(tr("The study could not be read"), study.error(), [this] { load(); });
        return;
    }
    m_open = std::move(*study);
    if (m_tab < 0)
        m_tab = m_open.editable() ? generalTab : participantsTab;
    psychophysics::StudyDesign design = m_open.design;
    if (!readOnly() && design.ownInstructions)
        renewInstructions(design); // an earlier version may have generated other sentences
    const bool renewed = design.instructions != m_open.design.instructions;
    {
        const QSignalBlocker quiet(&m_draft);
        m_draft.load(std::move(design));
    }
    m_good = m_saved = true;
    m_wrong = readOnly() ? std::vector<DesignFault>() : nameFaults(m_draft.design());
    build();
    m_panel->showContent();
    if (renewed)
        changed(); // it is stored like any other change
}

bool StudyScreen::readOnly() const {
    const bool own =
        m_open.summary.author == context().actor().personId() || context().has(database::Role::admin);
    return !m_open.editable() || !own;
}

void StudyScreen::build() {
    delete m_view; // removes the previous view
    m_back = m_next = nullptr;
    auto* scroll = new ScrollPage(context().theme(), 1200);
    m_view = scroll;
    QVBoxLayout* column = scroll->column();
    column->setSpacing(context().theme().px(12));
    column->addWidget(headRow());
    column->addWidget(toolRow());
    const QLocale locale = context().locale();
    QStringList names;
    for (const QString& name : {tr("Aim"), tr("Conditions"), tr("Trials"), tr("Questions"), tr("Preview"),
                                m_open.editable() ? tr("Check and freeze") : tr("Participants")})
        names << (m_open.editable() ? tr("%1. %2").arg(locale.toString(names.size() + 1), name) : name);
    m_bar = kit::tabBar(context().theme(), tr("Parts of the study"), names);
    m_bar->setObjectName(QStringLiteral("study.tabs"));
    m_bar->setCurrentIndex(m_tab);
    connect(m_bar, &QTabBar::currentChanged, this, &StudyScreen::showTab);
    column->addWidget(m_bar);
    // What cannot be changed has no faults, so nothing takes the room of the page.
    m_faults =
        new NoticeArea(context().theme(), readOnly() ? NoticeArea::Room::none : NoticeArea::Room::kept);
    m_faults->setObjectName(QStringLiteral("study.faults"));
    column->addWidget(m_faults);
    m_toFault = kit::button(context().theme(), tr("Show the first"), "", QStringLiteral("go-next"));
    m_toFault->setObjectName(QStringLiteral("study.to_fault"));
    m_toFault->hide();
    connect(m_toFault, &QPushButton::clicked, this, &StudyScreen::goToFirstFault);
    column->addWidget(m_toFault, 0, Qt::AlignLeft);
    auto* holder = new QWidget;
    m_holder = new QVBoxLayout(holder);
    m_holder->setContentsMargins(0, 0, 0, 0);
    m_page = nullptr;
    auto* row = new ResponsiveRow(context().theme().px(kBeside_px), context().theme().px(16));
    row->add(holder, 5);
    if (!m_open.masked) {
        auto* beside = new QWidget; // keeps the card no higher than its text
        auto* cards = new QVBoxLayout(beside);
        cards->setContentsMargins(0, 0, 0, 0);
        cards->addWidget(new ParticipantCard(designPage()));
        cards->addStretch();
        row->add(beside, 2);
    }
    column->addWidget(row, 1);
    if (m_open.editable())
        column->addWidget(stepRow());
    m_panel->setContent(scroll);
    showPage();
    showState();
}

QWidget* StudyScreen::headRow() {
    const Theme& theme = context().theme();
    auto* head = new QWidget;
    auto* column = new QVBoxLayout(head);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(4));
    column->addWidget(kit::label(theme, title(), TextStyle::heading));
    m_state = kit::label(theme, {}, TextStyle::body, "muted");
    m_state->setObjectName(QStringLiteral("study.state"));
    m_state->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_state);
    return head;
}

QWidget* StudyScreen::toolRow() {
    const Theme& theme = context().theme();
    auto* bar = new QWidget;
    auto* row = new FlowLayout(theme.px(8), bar);
    const auto add = [&](const char* name, const QString& text, const char* kind, const char* icon,
                         auto act) {
        auto* button = kit::button(theme, text, kind, QLatin1String(icon));
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, act);
        row->addWidget(button);
        return button;
    };
    m_freeze = m_undo = m_redo = nullptr;
    if (!readOnly()) {
        m_freeze = add("study.freeze", tr("Freeze …"), "primary", "object-locked", [this] { askFreeze(); });
        m_undo = add("study.undo", tr("Undo"), "", "edit-undo", [this] { m_draft.history().undo(); });
        m_redo = add("study.redo", tr("Redo"), "", "edit-redo", [this] { m_draft.history().redo(); });
        add("study.import", tr("Import …"), "quiet", "document-import", [this] { askImport(); });
    } else if (!m_open.editable()) {
        add("study.run", tr("Run"), "primary", "media-playback-start", [this] {
            context().navigator().go(QStringLiteral("study_run"),
                                     {{QStringLiteral("study"), qlonglong(m_study)}});
        });
        add("study.data", tr("Data"), "", "office-chart-line", [this] {
            context().navigator().go(QStringLiteral("study_data"),
                                     {{QStringLiteral("study"), qlonglong(m_study)}});
        });
    }
    if (!m_open.masked) // otherwise a file would contain a design that nobody froze
        add("study.copy", tr("Copy to new study …"), "quiet", "edit-copy", [this] { askCopy(); });
    if (!m_open.masked)
        add("study.export", tr("Save as JSON …"), "quiet", "document-save", [this] { askExport(); });
    auto* language = new QComboBox;
    language->setObjectName(QStringLiteral("study.language"));
    language->setAccessibleName(tr("Language of the texts"));
    for (const auto& [id, name] : languageChoices())
        language->addItem(name, id);
    language->setCurrentIndex(language->findData(m_language));
    language->setToolTip(tr("Language of the texts"));
    connect(language, &QComboBox::activated, this, [this, language] {
        m_language = language->currentData().toString();
        showPage();
    });
    row->addWidget(language);
    return bar;
}

QWidget* StudyScreen::stepRow() {
    const Theme& theme = context().theme();
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    m_back = kit::button(theme, tr("Back"), "", QStringLiteral("go-previous"));
    m_back->setObjectName(QStringLiteral("study.back"));
    connect(m_back, &QPushButton::clicked, this, [this] { step(-1); });
    m_next = kit::button(theme, tr("Next"), "primary", QStringLiteral("go-next"));
    m_next->setObjectName(QStringLiteral("study.next"));
    connect(m_next, &QPushButton::clicked, this, [this] { step(1); });
    row->addWidget(m_back);
    row->addStretch();
    row->addWidget(m_next);
    return bar;
}

void StudyScreen::keyPressEvent(QKeyEvent* event) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const QWidget* at = window()->focusWidget();
    const bool line = qobject_cast<const QLineEdit*>(at) || qobject_cast<const QAbstractSpinBox*>(at);
    if (enter && line && m_next && !m_next->isHidden() && m_page && m_page->isAncestorOf(at))
        step(1);
    else
        Screen::keyPressEvent(event);
}

/// Next leaves a page only if it has no errors. Its name in the bar above can always be chosen.
void StudyScreen::step(int by) {
    if (by > 0 && !readOnly()) {
        checkNow();
        for (const FieldGrid* grid : m_page->findChildren<FieldGrid*>())
            if (const QString name = grid->firstUnread(); !name.isEmpty()) { // input that could not be read
                goToField(m_tab, -1, name);
                return;
            }
        for (const DesignFault& fault : m_wrong)
            if (fault.tab == m_tab) {
                goToField(fault.tab, fault.condition, fault.field);
                return;
            }
    }
    showTab(std::clamp(m_tab + by, 0, tabs - 1));
}

void StudyScreen::goToFirstFault() {
    if (!m_wrong.empty())
        goToField(m_wrong.front().tab, m_wrong.front().condition, m_wrong.front().field);
}

void StudyScreen::goToField(int tab, int condition, const QString& field) {
    const bool otherCondition = condition >= 0 && condition != m_condition;
    if (condition >= 0)
        m_condition = condition;
    if (tab != m_tab)
        showTab(tab);
    else if (otherCondition)
        showPage();
    auto* found = field.isEmpty() || !m_page ? nullptr : m_page->findChild<QWidget*>(field);
    if (!found)
        return;
    found->setFocus(Qt::OtherFocusReason);
    QMetaObject::invokeMethod(
        found,
        [this, found] { // once the page has its size
            if (auto* scroll = qobject_cast<QScrollArea*>(m_view))
                scroll->ensureWidgetVisible(found, 0, context().theme().px(kCheck_ms / 3));
        },
        Qt::QueuedConnection);
}

/// Shows the errors under each field of the page, on the names of the pages, and above all of them.
void StudyScreen::showFaults() {
    if (!m_bar || readOnly())
        return;
    if (m_page) {
        const QMap<QString, QString> words = faultsOfPage(m_wrong, m_tab, m_condition);
        for (FieldGrid* grid : m_page->findChildren<FieldGrid*>())
            grid->showFaults(words);
    }
    for (int tab = 0; tab < m_bar->count(); ++tab) {
        const bool wrong = std::any_of(m_wrong.begin(), m_wrong.end(),
                                       [tab](const DesignFault& fault) { return fault.tab == tab; });
        m_bar->setTabIcon(tab, wrong ? context().theme().icon(QStringLiteral("dialog-error"), Colour::bad)
                                     : QIcon());
        m_bar->setTabToolTip(tab, wrong ? tr("Something here must be corrected.") : QString());
    }
    m_toFault->setVisible(!m_wrong.empty());
}

void StudyScreen::showTab(int tab) {
    m_tab = tab;
    if (m_bar && m_bar->currentIndex() != tab) {
        m_bar->setCurrentIndex(tab); // calls this function again
        return;
    }
    note();
    showPage();
    if (auto* page = qobject_cast<ScrollPage*>(m_view))
        page->verticalScrollBar()->setValue(0); // a new page starts at its top
}

void StudyScreen::note() {
    context().navigator().note({{QStringLiteral("study"), qlonglong(m_study)},
                                {QStringLiteral("tab"), m_tab},
                                {QStringLiteral("condition"), m_condition},
                                {QStringLiteral("participant"), m_participant}});
}

void StudyScreen::showPage() {
    if (!m_holder)
        return;
    sayPreviewEnds();
    QWidget* before = m_page;
    const QString focused =
        before && before->isAncestorOf(focusWidget()) ? focusWidget()->objectName() : QString();
    m_page = makePage();
    if (before) {
        m_holder->removeWidget(before);
        before->hide();
        before->deleteLater(); // one of its buttons may still be active
    }
    m_holder->addWidget(m_page);
    showFaults();
    if (m_back) {
        m_back->setEnabled(m_tab > 0);
        m_next->setVisible(m_tab + 1 < tabs);
    }
    if (!focused.isEmpty())
        if (auto* again = m_page->findChild<QWidget*>(focused))
            again->setFocus();
}

void StudyScreen::sayPreviewEnds() {
    if (const auto* preview = qobject_cast<PreviewPage*>(m_page); preview && preview->working())
        context().messages().information(tr("The preview was stopped because you left its page, and nothing "
                                            "of it was kept. Press Preview there to calculate it again."));
}

DesignPage StudyScreen::designPage() {
    return {context(), m_draft, readOnly(), m_language, m_open.blinding, m_open.masked};
}

QWidget* StudyScreen::makePage() {
    const DesignPage page = designPage();
    switch (m_tab) {
    case conditionsTab: {
        auto* conditions = new ConditionsPage(page, m_condition);
        m_condition = conditions->shown();
        connect(conditions, &ConditionsPage::showAsked, this, [this](int condition) {
            m_condition = condition;
            note();
            QMetaObject::invokeMethod(this, &StudyScreen::showPage, Qt::QueuedConnection);
        });
        return conditions;
    }
    case trialsTab:
        return new RulesPage(page);
    case questionnairesTab:
        return new QuestionnairesPage(page);
    case previewTab:
        return new PreviewPage(page);
    case participantsTab: {
        if (m_open.editable())
            return makeCheckPage(page);
        auto* participants = new ParticipantsPage(context(), m_open, m_participant);
        connect(participants, &ParticipantsPage::selectedChanged, this, [this](const QString& code) {
            m_participant = code;
            note();
        });
        connect(participants, &ParticipantsPage::changed, this, [this] { reloadTo(participantsTab); });
        connect(participants, &ParticipantsPage::enrolOpened, this, [this](EnrolDialog* dialog) {
            connect(dialog, &EnrolDialog::consentAsked, this, &StudyScreen::askConsent);
        });
        return participants;
    }
    default:
        return new GeneralPage(page);
    }
}

void StudyScreen::askConsent(const database::Participant& participant) {
    auto* dialog = new ConsentDialog(context(), m_open, participant, window());
    connect(dialog, &ConsentDialog::changed, this, [this] { reloadTo(participantsTab); });
    dialog->open();
}

QWidget* StudyScreen::makeCheckPage(const DesignPage& page) {
    auto* check = new CheckPage(page, m_open, m_wrong);
    connect(
        check, &CheckPage::goAsked, this,
        [this](const FreezeCheck& line) { goToField(line.tab, line.condition, line.field); },
        Qt::QueuedConnection);
    connect(check, &CheckPage::pilotAsked, this, &StudyScreen::askPilot);
    connect(check, &CheckPage::freezeAsked, this, &StudyScreen::askFreeze);
    return check;
}

std::vector<ScreenCommand> StudyScreen::commands() {
    std::vector<ScreenCommand> list{
        {tr("Save as JSON …"), QKeySequence(QKeySequence::Save), [this] { askExport(); }}};
    if (m_undo) {
        list.push_back({tr("Undo"), QKeySequence(QKeySequence::Undo), [this] { m_draft.history().undo(); }});
        list.push_back({tr("Redo"), QKeySequence(QKeySequence::Redo), [this] { m_draft.history().redo(); }});
        list.push_back({tr("Freeze …"), {}, [this] { askFreeze(); }});
    }
    return list;
}

} // namespace chiron::desktop
