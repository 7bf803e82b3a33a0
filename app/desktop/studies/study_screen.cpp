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
#include <QResizeEvent>
#include <QScrollBar>
#include <QTabBar>
#include <algorithm>
#include <functional>
#include <utility>

namespace chiron::desktop {

namespace {
constexpr int kCheck_ms = 300;
constexpr double kBeside_px = 800;       // total width of page and card
constexpr double kLeastForMissing = 180; // margins, spacing and a word of what freezing waits for

/// The bar below the page. Its width decides how much the button Next says.
class StepBar final : public QWidget {
public:
    explicit StepBar(std::function<void()> resized) : m_resized(std::move(resized)) {}

protected:
    void resizeEvent(QResizeEvent* event) override {
        QWidget::resizeEvent(event);
        m_resized();
    }

private:
    std::function<void()> m_resized;
};
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

/// The stack says that it is emptied when it is destroyed, and what the screen shows is gone by then.
StudyScreen::~StudyScreen() {
    m_draft.history().disconnect(this);
}

QString StudyScreen::title() const {
    const QString name = QString::fromStdString(m_open.summary.title);
    return name.isEmpty() ? tr("Study") : name;
}

QString StudyScreen::help() const {
    return tr("One study. While it is a draft, you can change everything. Go through the pages with \"Next\" "
              "and \"Back\", or jump to one by its name. Complete entries are saved at once, Ctrl+Z undoes a "
              "step, and a message under a field says what is wrong with it. Beside the pages you see what a "
              "participant will see.\n\n\"Conditions\" defines what is compared, with which task and "
              "procedure. \"Expected precision\" runs the "
              "study with simulated observers and shows the expected precision, number of trials and time. "
              "\"Check and freeze\" says what is missing, lets somebody try the design as a pilot, and "
              "freezes it permanently under its "
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
    if (!readOnly())
        for (const FreezeCheck& check : missing()) // whoever opens it begins where something is needed
            if (check.tab == m_tab && !check.field.isEmpty()) {
                goToField(check.tab, check.condition, check.field);
                break;
            }
}

bool StudyScreen::readOnly() const {
    const bool own =
        m_open.summary.author == context().actor().personId() || context().has(database::Role::admin);
    return !m_open.editable() || !own;
}

void StudyScreen::build() {
    delete m_view; // removes the previous view
    m_back = m_next = nullptr;
    m_missing = nullptr;
    m_steps = nullptr;
    auto* scroll = new ScrollPage(context().theme(), 1200);
    m_scroll = scroll;
    m_view = new QWidget;
    auto* whole = new QVBoxLayout(m_view);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->setSpacing(0);
    whole->addWidget(scroll, 1);
    QVBoxLayout* column = scroll->column();
    column->setSpacing(context().theme().px(12));
    column->addWidget(headRow());
    column->addWidget(toolRow());
    const QLocale locale = context().locale();
    m_tabNames.clear();
    QStringList names;
    for (const QString& name :
         {tr("Aim"), tr("Conditions"), tr("Trials"), tr("Questions"), tr("Expected precision"),
          m_open.editable() ? tr("Check and freeze") : tr("Participants")}) {
        m_tabNames << name;
        names << (m_open.editable() ? tr("%1. %2").arg(locale.toString(names.size() + 1), name) : name);
    }
    m_bar = kit::tabBar(context().theme(), tr("Parts of the study"), names);
    m_bar->setObjectName(QStringLiteral("study.tabs"));
    m_bar->setCurrentIndex(m_tab);
    connect(m_bar, &QTabBar::currentChanged, this, &StudyScreen::showTab);
    column->addWidget(m_bar);
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
    whole->addWidget(faultBar());
    if (m_open.editable()) // below the page, so that nobody scrolls to go on
        whole->addWidget(stepRow());
    m_panel->setContent(m_view);
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

/// What is wrong, below the page: it takes room from the end of the page only while something is wrong, and
/// no control of the page moves when it appears.
QWidget* StudyScreen::faultBar() {
    const Theme& theme = context().theme();
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(theme.px(24), 0, theme.px(24), 0);
    row->setSpacing(theme.px(12));
    m_faults = new NoticeArea(theme, NoticeArea::Room::none);
    m_faults->setObjectName(QStringLiteral("study.faults"));
    row->addWidget(m_faults, 1);
    m_toFault = kit::button(theme, tr("Show the first"), "", QStringLiteral("go-next"));
    m_toFault->setObjectName(QStringLiteral("study.to_fault"));
    m_toFault->hide();
    connect(m_toFault, &QPushButton::clicked, this, &StudyScreen::goToFirstFault);
    row->addWidget(m_toFault);
    return bar;
}

QWidget* StudyScreen::stepRow() {
    const Theme& theme = context().theme();
    auto* bar = new StepBar([this] { showSteps(); });
    m_steps = bar;
    auto* column = new QVBoxLayout(bar);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(kit::rule());
    auto* row = new QHBoxLayout;
    column->addLayout(row);
    row->setContentsMargins(theme.px(24), theme.px(8), theme.px(24), theme.px(8));
    row->setSpacing(theme.px(12));
    m_back = kit::button(theme, tr("Back"), "", QStringLiteral("go-previous"));
    m_back->setObjectName(QStringLiteral("study.back"));
    connect(m_back, &QPushButton::clicked, this, [this] { step(-1); });
    m_next = kit::button(theme, tr("Next"), "primary", QStringLiteral("go-next"));
    m_next->setObjectName(QStringLiteral("study.next"));
    connect(m_next, &QPushButton::clicked, this, &StudyScreen::stepOn);
    m_missing = kit::label(theme, {}, TextStyle::small, "muted");
    m_missing->setObjectName(QStringLiteral("study.missing"));
    m_missing->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(m_back);
    row->addWidget(m_missing, 1);
    row->addWidget(m_next);
    return bar;
}

/// The next page by its name, and what freezing still waits for.
void StudyScreen::showSteps() {
    if (!m_next)
        return;
    m_back->setEnabled(m_tab > 0);
    QStringList needed;
    if (!readOnly())
        for (const FreezeCheck& check : missing())
            needed << check.title;
    m_missing->setText(needed.isEmpty()
                           ? QString()
                           : tr("Needed before it can be frozen: %1").arg(needed.join(QStringLiteral(", "))));
    const bool last = m_tab + 1 >= tabs;
    m_next->setVisible(!last || !readOnly());
    const QString words = nextWords(needed);
    m_next->setText(words);
    m_next->setAccessibleName(words);
    // Large type leaves no room for the name of the page; the bar above shows it.
    const int room = m_steps->width() - m_back->sizeHint().width() - context().theme().px(kLeastForMissing);
    if (m_next->sizeHint().width() > room)
        m_next->setText(last && needed.isEmpty() ? tr("Freeze …") : tr("Next"));
}

QString StudyScreen::nextWords(const QStringList& needed) const {
    if (m_tab + 1 < tabs)
        return tr("Next: %1").arg(m_tabNames.value(m_tab + 1));
    return needed.isEmpty() ? tr("Freeze …") : tr("Next: correct “%1”").arg(needed.front());
}

std::vector<FreezeCheck> StudyScreen::missing() const {
    std::vector<FreezeCheck> checks =
        freezeChecks(m_draft.design(), {m_wrong, std::nullopt}, context().locale());
    std::erase_if(checks, [](const FreezeCheck& check) { return check.state != FreezeCheck::State::bad; });
    return checks;
}

void StudyScreen::stepOn() {
    if (m_tab + 1 < tabs)
        step(1);
    else if (const std::vector<FreezeCheck> first = missing(); !first.empty())
        goToField(first.front().tab, first.front().condition, first.front().field);
    else
        askFreeze();
}

void StudyScreen::keyPressEvent(QKeyEvent* event) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const QWidget* at = window()->focusWidget();
    const bool line = qobject_cast<const QLineEdit*>(at) || qobject_cast<const QAbstractSpinBox*>(at);
    if (enter && line && m_next && m_tab + 1 < tabs && m_page && m_page->isAncestorOf(at))
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
            if (m_scroll)
                m_scroll->ensureWidgetVisible(found, 0, context().theme().px(kCheck_ms / 3));
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
    if (m_scroll)
        m_scroll->verticalScrollBar()->setValue(0); // a new page starts at its top
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
    showSteps();
    if (!focused.isEmpty())
        if (auto* again = m_page->findChild<QWidget*>(focused))
            again->setFocus();
}

void StudyScreen::sayPreviewEnds() {
    if (const auto* preview = qobject_cast<PreviewPage*>(m_page); preview && preview->working())
        context().messages().information(tr("The simulation was stopped because you left its page, and "
                                            "nothing of it was kept. Press “Estimate the precision” there to "
                                            "calculate it again."));
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
    case trialsTab: {
        auto* rules = new RulesPage(page);
        connect(
            rules, &RulesPage::lengthAsked, this,
            [this](int condition, const QString& field) { goToField(conditionsTab, condition, field); },
            Qt::QueuedConnection); // the button that asks is on the page that is left
        return rules;
    }
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
