// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_data/study_data_screen.h"

#include "desktop/studies/study_words.h"
#include "desktop/study_data/apex_page.h"
#include "desktop/study_data/comparison_page.h"
#include "desktop/study_data/group_page.h"
#include "desktop/study_data/person_page.h"
#include "desktop/study_data/questionnaire_summary.h"
#include "desktop/study_data/run_choice.h"
#include "desktop/study_data/trials_page.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QTabBar>
#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr auto kWithShown = "study_data_with_shown";
}

StudyDataScreen::StudyDataScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_study(place.parameters.value(QStringLiteral("study")).toLongLong()),
      m_tab(std::clamp(place.parameters.value(QStringLiteral("tab")).toInt(), 0, tabs - 1)),
      m_condition(static_cast<std::size_t>(place.parameters.value(QStringLiteral("condition")).toUInt())),
      m_run(place.parameters.value(QStringLiteral("run")).toLongLong()),
      m_withShown(context.settings()
                      .ofPerson(context.actor().personId(), QString::fromLatin1(kWithShown), false)
                      .toBool()) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_panel = new StatePanel(context.theme());
    column->addWidget(m_panel);
}

StudyDataScreen::~StudyDataScreen() {
    if (m_work)
        m_work->cancel();
}

QString StudyDataScreen::title() const {
    return tr("Data");
}

QString StudyDataScreen::help() const {
    return tr(
        "The results of a study.\n\n\"Group\" shows each participant's Weber fraction with its interval "
        "for every condition, and any "
        "warnings. \"Person\" shows the curve of a run with its data. \"Trials\" lists every presentation "
        "with "
        "its fidelity and says why one "
        "did not count. \"Questions\" summarises the questionnaires. \"Comparison\" sets the conditions "
        "beside "
        "each other, and says who or what is "
        "missing where they cannot be compared.\n\nYou can export tables (CSV), a BIDS dataset or a "
        "PDF; each "
        "contains the design's SHA-256. While the experimenter is blind, conditions are shown by "
        "sealed codes, and of their runs you "
        "see only how well each participant's trials went. Unblinding asks for a reason, is recorded "
        "and cannot be undone.");
}

void StudyDataScreen::enter() {
    loadList();
}

void StudyDataScreen::loadList() {
    m_panel->showLoading(
        tr("Reading the studies …"),
        readStudies(
            context(), this, [](database::StudyReader& reader) { return reader.listStudies(true); },
            [this](core::Result<std::vector<database::StudySummary>> list) {
                if (!list) {
                    m_panel->showError(tr("The studies could not be read"), list.error(),
                                       [this] { loadList(); });
                    return;
                }
                m_list.clear();
                for (database::StudySummary& each : *list)
                    if (!each.sha256.empty())
                        m_list.push_back(std::move(each));
                if (m_list.empty()) {
                    m_panel->showEmpty(tr("No data yet"),
                                       tr("Data appear here once participants have taken part in a "
                                          "frozen study."),
                                       tr("Open the studies"),
                                       [this] { context().navigator().go(QStringLiteral("studies")); });
                    return;
                }
                if (m_study == 0)
                    m_study = m_list.back().id;
                load();
            }));
}

void StudyDataScreen::load() {
    database::Database& database = context().site().database();
    m_work = context().background().run(
        this,
        [&database, actor = context().actor(), study = m_study,
         withShown = m_withShown](WorkToken&) -> core::Result<StudyFacts> {
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            database::StudyReader reader(**connection, actor);
            return studyFacts(reader, study, withShown);
        },
        [this](core::Result<StudyFacts> facts) { loaded(std::move(facts)); });
    m_panel->showLoading(tr("Analysing the runs …"));
}

void StudyDataScreen::loaded(core::Result<StudyFacts> facts) {
    if (!facts) {
        m_panel->showError(tr("The study could not be analysed"), facts.error(), [this] { load(); });
        return;
    }
    m_facts = std::move(*facts);
    m_condition = std::min(m_condition, m_facts.groups.size() - 1);
    build();
    m_panel->showContent();
}

void StudyDataScreen::build() {
    const Theme& theme = context().theme();
    auto* page = new ScrollPage(theme, 1200);
    QVBoxLayout* column = page->column();
    column->setSpacing(theme.px(12));
    column->addWidget(headRow());
    column->addWidget(toolRow());
    m_bar = kit::tabBar(theme, tr("Views of the data"),
                        {tr("Group"), tr("Person"), tr("Trials"), tr("Questions"), tr("Comparison")});
    m_bar->setObjectName(QStringLiteral("data.tabs"));
    m_bar->setCurrentIndex(m_tab);
    connect(m_bar, &QTabBar::currentChanged, this, [this](int tab) {
        m_tab = tab;
        showPage();
    });
    column->addWidget(m_bar);
    auto* holder = new QWidget;
    m_holder = new QVBoxLayout(holder);
    m_holder->setContentsMargins(0, 0, 0, 0);
    m_page = nullptr;
    column->addWidget(holder);
    column->addStretch();
    delete m_panel->content();
    m_panel->setContent(page);
    showPage();
}

QWidget* StudyDataScreen::headRow() {
    const Theme& theme = context().theme();
    auto* head = new QWidget;
    auto* column = new QVBoxLayout(head);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(6));
    auto* choice = new QComboBox;
    choice->setObjectName(QStringLiteral("data.study"));
    choice->setAccessibleName(tr("Study"));
    choice->setFont(theme.font(TextStyle::body));
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const database::StudySummary& each : m_list)
        choice->addItem(study_words::studyName(each), qlonglong(each.id));
    choice->setCurrentIndex(choice->findData(qlonglong(m_study)));
    connect(choice, &QComboBox::activated, this, [this, choice] {
        m_study = choice->currentData().toLongLong();
        m_run = 0;
        m_condition = 0;
        load();
    });
    column->addWidget(kit::label(theme, title(), TextStyle::heading));
    column->addWidget(choice);
    const database::StudySummary& study = m_facts.study.summary;
    QStringList words{study_words::state(study.state),
                      tr("SHA-256 %1").arg(study_words::shortSha(study.sha256)),
                      tr("%n participant(s)", nullptr, study.participants),
                      tr("%n scored trial(s)", nullptr, study.trials)};
    if (m_facts.study.design.blindExperimenter)
        words << (study.unblinded ? tr("unblinded") : tr("blind: conditions shown by sealed codes"));
    auto* facts = kit::label(theme, words.join(QStringLiteral(" · ")), TextStyle::body, "muted");
    facts->setObjectName(QStringLiteral("data.facts"));
    column->addWidget(facts);
    if (!m_facts.sealed) // a sealed study shows nothing of a group
        column->addWidget(shownChoice());
    return head;
}

/// Always visible, because it determines what every value on the pages refers to. The choice is stored for
/// the person.
QWidget* StudyDataScreen::shownChoice() {
    auto* shown = new QCheckBox(tr("Groups include runs with force shown, not felt"));
    shown->setObjectName(QStringLiteral("data.with_shown"));
    shown->setFont(context().theme().font(TextStyle::body));
    shown->setToolTip(m_facts.anyShown
                          ? tr("It applies to every page here and to the PDF, and is remembered.")
                          : tr("In no run of this study was force only shown, so this changes nothing here. "
                               "The choice is remembered."));
    shown->setChecked(m_withShown);
    connect(shown, &QCheckBox::clicked, this, [this](bool checked) {
        m_withShown = checked;
        context().settings().setOfPerson(context().actor().personId(), QString::fromLatin1(kWithShown),
                                         checked);
        load();
    });
    return shown;
}

void StudyDataScreen::note() {
    context().navigator().note({{QStringLiteral("study"), qlonglong(m_study)},
                                {QStringLiteral("tab"), m_tab},
                                {QStringLiteral("condition"), static_cast<uint>(m_condition)},
                                {QStringLiteral("run"), qlonglong(m_run)}});
}

ApexPage* StudyDataScreen::listening(ApexPage* page) {
    connect(page, &ApexPage::conditionChosen, this, [this](uint condition) {
        m_condition = condition;
        QMetaObject::invokeMethod(this, &StudyDataScreen::showPage, Qt::QueuedConnection);
    });
    connect(page, &ApexPage::runOpened, this, [this](qlonglong run) {
        m_run = run;
        m_bar->setCurrentIndex(personTab);
    });
    connect(page, &ApexPage::runChosen, this, [this](qlonglong run) {
        m_run = run;
        QMetaObject::invokeMethod(this, &StudyDataScreen::showPage, Qt::QueuedConnection);
    });
    return page;
}

void StudyDataScreen::showPage() {
    note();
    if (m_page) {
        m_page->hide();
        m_page->deleteLater();
    }
    switch (m_tab) {
    case personTab: {
        if (const RunFacts* run = runOf(m_facts, m_run); run && run->apex) {
            m_page = listening(new ApexPage(context(), m_facts, *run));
            break;
        }
        auto* page = new PersonPage(context(), m_facts, m_run);
        connect(page, &PersonPage::runChosen, this, [this](qlonglong run) {
            m_run = run;
            QMetaObject::invokeMethod(this, &StudyDataScreen::showPage, Qt::QueuedConnection);
        });
        m_page = page;
        break;
    }
    case trialsTab: {
        auto* page = new TrialsPageOfRun(context(), m_facts, m_run);
        connect(page, &TrialsPageOfRun::runChosen, this, [this](qlonglong run) {
            m_run = run;
            QMetaObject::invokeMethod(this, &StudyDataScreen::showPage, Qt::QueuedConnection);
        });
        m_page = page;
        break;
    }
    case questionnairesTab:
        m_page = new QuestionnaireSummary(context(), m_facts);
        break;
    case comparisonTab:
        m_page = new ComparisonPage(context(), m_facts);
        break;
    default: {
        if (m_facts.apexes[m_condition]) {
            m_page = listening(new ApexPage(context(), m_facts, m_condition));
            break;
        }
        auto* page = new GroupPage(context(), m_facts, m_condition);
        connect(page, &GroupPage::conditionChosen, this, [this](uint condition) {
            m_condition = condition;
            QMetaObject::invokeMethod(this, &StudyDataScreen::showPage, Qt::QueuedConnection);
        });
        connect(page, &GroupPage::comparisonAsked, this, [this] { m_bar->setCurrentIndex(comparisonTab); });
        connect(page, &GroupPage::runOpened, this, [this](qlonglong run) {
            m_run = run;
            m_bar->setCurrentIndex(personTab);
        });
        m_page = page;
        break;
    }
    }
    m_holder->addWidget(m_page);
}

} // namespace chiron::desktop
