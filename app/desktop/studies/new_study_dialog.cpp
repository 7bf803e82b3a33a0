// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/new_study_dialog.h"

#include "catalogue/study_catalogue.h"
#include "desktop/accounts/form.h"
#include "desktop/frame/palette_search.h"
#include "desktop/studies/difference_table.h"
#include "desktop/studies/general_page.h"
#include "desktop/studies/participant_card.h"
#include "desktop/studies/participant_sentences.h"
#include "desktop/studies/study_jobs.h"
#include "desktop/studies/study_titles.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/suggested_text.h"
#include "desktop/widgets/tile_button.h"
#include "psychophysics/procedures/procedure_catalogue.h"

#include <QButtonGroup>
#include <QKeyEvent>
#include <QLineEdit>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {

constexpr int kDifferences = 40;
constexpr double kSmallest_percent = 2.0;
constexpr double kLargest_percent = 60.0;
constexpr double kUsualStiffness_N_per_m = 300.0;
/// As the templates have it; a researcher adds what only they know, such as how long recordings are kept.
constexpr const char* kUsualConsent =
    "Taking part is voluntary. I may stop at any time without giving a reason and without disadvantage. My "
    "answers, movements and forces are recorded under a code; only a separate list kept by the head of the "
    "study shows whose code it is. I may have this entry, my free-text answers and my questionnaires erased, "
    "together with the recordings. I have read the instructions, was able to ask questions, and agree to "
    "take part.";

/// A text as words to search in and for: "two-alternative" has the words of "two alternative".
QString searchable(const QString& text) {
    static const QRegularExpression kBetweenWords(QStringLiteral("[^\\p{L}\\p{N}]+"));
    return forSearch(text).replace(kBetweenWords, QStringLiteral(" "));
}

/// The text by which a template is found; also in English, the language of its source.
QString wordsOf(const psychophysics::StudyDesign& design, const QString& title, const QString& objective) {
    QStringList words{title, objective, QString::fromStdString(design.source),
                      study_words::text(design.title, QStringLiteral("en"))};
    for (const psychophysics::Condition& condition : design.conditions) {
        words << study_words::attribute(condition.stimulus.attribute) << study_words::task(condition.task)
              << study_words::otherNames(condition.stimulus.attribute)
              << study_words::otherNames(condition.task);
        for (const psychophysics::ProcedureSpec& procedure : condition.procedures)
            words << study_words::procedure(psychophysics::kindOf(procedure));
    }
    words << study_words::otherNames(design.conditions);
    return searchable(words.join(QLatin1Char(' ')));
}

} // namespace

psychophysics::StudyDesign plainStudy(psychophysics::Task task) {
    psychophysics::StudyDesign study;
    study.id = "new_" + std::string(psychophysics::token(task));
    study.title["en"] = "New study";
    study.objective["en"] = kPlaceholderAim;
    study.ownInstructions = psychophysics::StudyText{{"en", "Explore all objects, then answer."}};
    study.consent["en"] = kUsualConsent;
    psychophysics::Condition condition;
    condition.id = "stiffness";
    condition.title["en"] = "Stiffness";
    condition.stimulus.reference = kUsualStiffness_N_per_m;
    for (int i = 0; i < kDifferences; ++i) {
        const double part = static_cast<double>(i) / (kDifferences - 1);
        condition.stimulus.differences.push_back(study_words::differenceOf(
            0.01 * kSmallest_percent * std::pow(kLargest_percent / kSmallest_percent, part)));
    }
    takeTask(condition, task);
    study.conditions = {condition};
    study.trial.probeAtLeast_N = psychophysics::kUsualProbe_N;
    renewInstructions(study);
    return study;
}

psychophysics::StudyDesign copyOf(psychophysics::StudyDesign design) {
    design.ethics.clear();
    design.pilotOf.clear();
    return design;
}

NewStudyDialog::NewStudyDialog(AppContext& context, const QString& title, QWidget* parent)
    : FormDialog(context, QStringLiteral("new_study"), title, parent) {}

NewStudyDialog::NewStudyDialog(AppContext& context, QWidget* parent)
    : NewStudyDialog(context, tr("New study"), parent) {
    addTemplates();
    addNames();
    renew();
    loadTaken();
    loadTemplates();
    m_filter->setFocus();
}

NewStudyDialog::NewStudyDialog(AppContext& context, const psychophysics::StudyDesign& copied, QWidget* parent)
    : NewStudyDialog(context, tr("Copy to a new study"), parent) {
    m_templates = {copyOf(copied)};
    column()->addWidget(kit::label(theme(), tr("The copy is a draft with the whole design of “%1”, without "
                                               "its participants, data and ethics approval.")
                                                .arg(study_words::text(copied.title, context.language()))));
    addNames();
    suggestTitle();
    renew();
    loadTaken();
    m_title->setFocus();
}

void NewStudyDialog::addTemplates() {
    column()->addWidget(kit::label(
        theme(),
        tr("Each template is a complete design. Everything in it can be changed until the study is frozen."),
        TextStyle::small, "muted"));
    m_filter = form::textField(theme(), column(), tr("Find a template"), QStringLiteral("new_study.filter"));
    m_filter->setPlaceholderText(tr("For example: 2AFC, weight, two conditions, Watson"));
    m_filter->setClearButtonEnabled(true);
    m_filter->installEventFilter(this);
    connect(m_filter, &QLineEdit::textChanged, this, &NewStudyDialog::filter);
    column()->addWidget(kit::label(theme(), tr("Begin with"), TextStyle::label));
    m_none = kit::label(theme(), {}, TextStyle::body, "muted");
    m_none->setObjectName(QStringLiteral("new_study.none"));
    m_none->hide();
    column()->addWidget(m_none);
    m_list = new QWidget;
    auto* rows = new QVBoxLayout(m_list);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(theme().px(8));
    column()->addWidget(m_list);
    m_choice = new QButtonGroup(this);
    connect(m_choice, &QButtonGroup::idClicked, this, &NewStudyDialog::choose);
}

void NewStudyDialog::addNames() {
    const auto fault = [this](const char* name) {
        auto* words = kit::label(theme(), {}, TextStyle::small, "bad");
        words->setObjectName(QLatin1String(name));
        words->hide();
        column()->addWidget(words);
        return words;
    };
    m_title = form::textField(theme(), column(), tr("Title"), QStringLiteral("new_study.title"));
    m_titleFault = fault("new_study.title.fault");
    m_key = form::textField(theme(), column(), tr("Key (in files and commands)"),
                            QStringLiteral("new_study.key"));
    m_keyFault = fault("new_study.key.fault");
    column()->addWidget(kit::label(theme(),
                                   tr("Lower-case letters, digits and _ only. It cannot be changed later."),
                                   TextStyle::small, "muted"));
    for (QLineEdit* field : {m_title, m_key})
        new SuggestedText(*field);
    setAccept(tr("Create draft"));
    connect(m_title, &QLineEdit::textEdited, this, [this](const QString& typed) {
        m_ownTitle = !typed.isEmpty();
        suggestKey();
        renew();
    });
    connect(m_key, &QLineEdit::textEdited, this, [this](const QString& typed) {
        m_ownKey = !typed.isEmpty();
        renew();
    });
}

/// Loads the existing keys and titles, so that a conflict is reported while the form is filled in, not on
/// submission.
void NewStudyDialog::loadTaken() {
    readStudies(
        context(), this, [](database::StudyReader& reader) { return reader.listStudies(true); },
        [this](const core::Result<std::vector<database::StudySummary>>& studies) {
            if (!studies)
                return;
            for (const database::StudySummary& each : *studies) {
                m_keys.insert(QString::fromStdString(each.key));
                m_titles.insert(titleForComparison(QString::fromStdString(each.title)));
            }
            suggestTitle();
            renew();
        });
}

void NewStudyDialog::loadTemplates() {
    context().background().run(
        this, [](WorkToken&) { return catalogue::StudyCatalogue::load(); },
        [this](const core::Result<catalogue::StudyCatalogue>& studies) {
            if (!studies)
                say("warning",
                    tr("The templates could not be read.\n%1").arg(inWords(studies.error(), Tried::reading)));
            showTemplates(studies ? studies->studies() : std::vector<psychophysics::StudyDesign>());
        });
}

void NewStudyDialog::showTemplates(std::vector<psychophysics::StudyDesign> templates) {
    m_templates = std::move(templates);
    const std::size_t complete = m_templates.size();
    for (int task = 0; task < psychophysics::kTasks; ++task)
        m_templates.push_back(plainStudy(static_cast<psychophysics::Task>(task)));
    for (std::size_t i = 0; i < m_templates.size(); ++i)
        m_list->layout()->addWidget(tile(i, i >= complete));
    filter(); // the person may already have typed
    renew();
}

/// A template's tile: its aim, the participant's task, and the publication.
QWidget* NewStudyDialog::tile(std::size_t index, bool plain) {
    const psychophysics::StudyDesign& design = m_templates[index];
    const psychophysics::Task task = design.conditions.front().task;
    const QString title = plain ? tr("A simple study: %1").arg(study_words::task(task))
                                : study_words::text(design.title, context().language());
    const QString objective = plain ? tr("One condition, stiffness. %1").arg(study_words::taskInWords(task))
                                    : study_words::text(design.objective, context().language());
    QStringList meets;
    if (design.conditions.size() > 1) {
        QStringList names;
        for (const psychophysics::Condition& condition : design.conditions)
            names << study_words::text(condition.title, context().language());
        meets << tr("Conditions: %1").arg(names.join(QStringLiteral(", ")));
    }
    for (const auto& [name, words] : participantFacts(design, context().locale(), context().language())) {
        if (name == QStringLiteral("trials"))
            meets << tr("Trials: %1").arg(words);
        else if (name == QStringLiteral("minutes"))
            meets << tr("Duration: %1").arg(words);
    }
    auto* tile = new TileButton(theme());
    tile->setCheckable(true);
    tile->setObjectName(QStringLiteral("new_study.template.%1").arg(QString::fromStdString(design.id)));
    const QString source = QString::fromStdString(design.source);
    tile->setAccessibleName(tr("%1. %2").arg(title, objective));
    m_folded.push_back(wordsOf(design, title, objective));
    tile->setAccessibleDescription(meets.join(QStringLiteral(". ")) + QStringLiteral(". ") + source);
    auto* words = new QVBoxLayout;
    words->addWidget(kit::label(theme(), title, TextStyle::strong));
    words->addWidget(kit::label(theme(), objective, TextStyle::small, "muted"));
    words->addWidget(kit::label(theme(), meets.join(QStringLiteral(" · ")), TextStyle::small));
    if (!source.isEmpty()) {
        auto* cited = kit::label(theme(), tr("After: %1").arg(source), TextStyle::small, "muted");
        cited->setObjectName(tile->objectName() + QStringLiteral(".source"));
        words->addWidget(cited);
    }
    tile->row()->addLayout(words, 1);
    tile->seal();
    tile->installEventFilter(this);
    m_choice->addButton(tile, static_cast<int>(index));
    return tile;
}

const psychophysics::StudyDesign* NewStudyDialog::chosen() const {
    const int index = m_choice ? m_choice->checkedId() : 0;
    return index >= 0 && static_cast<std::size_t>(index) < m_templates.size()
               ? &m_templates[static_cast<std::size_t>(index)]
               : nullptr;
}

void NewStudyDialog::choose(int) {
    suggestTitle();
    renew();
    filter();                              // the previously chosen one may now be hidden
    m_title->setFocus(Qt::TabFocusReason); // with the whole text selected, to be typed over
    // Once the tiles that stay have their places. An arrow key moves on to the next tile, which may lie below
    // what is in sight.
    QMetaObject::invokeMethod(
        this,
        [this] {
            QWidget* at = focusWidget();
            if (at == m_title || (at && m_list->isAncestorOf(at)))
                reveal(*at);
        },
        Qt::QueuedConnection);
}

bool NewStudyDialog::isFound(int index) const {
    const QStringList words = searchable(m_filter->text()).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    const QString& in = m_folded[static_cast<std::size_t>(index)];
    return std::all_of(words.begin(), words.end(), [&](const QString& word) { return in.contains(word); });
}

std::optional<int> NewStudyDialog::firstFound() const {
    for (std::size_t i = 0; i < m_folded.size(); ++i)
        if (isFound(static_cast<int>(i)))
            return static_cast<int>(i);
    return std::nullopt;
}

/// The chosen template stays visible whatever is typed, so that nobody creates a study from one that is
/// hidden.
void NewStudyDialog::filter() {
    for (QAbstractButton* tile : m_choice->buttons())
        tile->setVisible(tile->isChecked() || isFound(m_choice->id(tile)));
    const bool none = !m_folded.empty() && !firstFound();
    m_none->setText(
        none ? tr("No template matches “%1”. Try fewer or other words.").arg(m_filter->text().simplified())
             : QString());
    m_none->setVisible(none);
}

bool NewStudyDialog::eventFilter(QObject* watched, QEvent* event) {
    // Otherwise the tile would move away from under the mouse.
    if (event->type() == QEvent::FocusIn &&
        static_cast<QFocusEvent*>(event)->reason() != Qt::MouseFocusReason)
        if (auto* tile = qobject_cast<TileButton*>(watched))
            reveal(*tile);
    if (watched != m_filter || event->type() != QEvent::KeyPress)
        return FormDialog::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key != Qt::Key_Return && key != Qt::Key_Enter && key != Qt::Key_Down)
        return FormDialog::eventFilter(watched, event);
    const std::optional<int> first = firstFound();
    QAbstractButton* tile = first ? m_choice->button(*first) : nullptr;
    if (tile && key == Qt::Key_Down) {
        tile->setFocus(Qt::TabFocusReason);
    } else if (tile) {
        tile->click(); // moves on to the title
    }
    return true; // Enter in the filter never creates a study
}

/// Suggests a free title until the person types one; for a copy it is derived from the original's title.
void NewStudyDialog::suggestTitle() {
    const psychophysics::StudyDesign* design = chosen();
    if (design && !m_ownTitle) {
        const QString title = study_words::text(design->title, QStringLiteral("en"));
        m_title->setText(m_choice ? freeTitle(title, m_titles) : copyTitle(title, m_titles));
        m_title->selectAll();
    }
    suggestKey();
}

void NewStudyDialog::suggestKey() {
    if (m_ownKey || !chosen())
        return;
    const bool untouched = m_choice && !m_ownTitle;
    const QString key = untouched ? QString::fromStdString(chosen()->id) : shortNameOf(m_title->text());
    m_key->setText(key.isEmpty() ? QString() : freeShortName(key, m_keys));
}

QString NewStudyDialog::titleFault() const {
    if (m_title->text().trimmed().isEmpty())
        return tr("Give the study a title.");
    return m_titles.contains(titleForComparison(m_title->text()))
               ? tr("Another study has this title, and the two could not be told apart in lists. Choose "
                    "another title.")
               : QString();
}

QString NewStudyDialog::keyFault() const {
    const QString key = m_key->text();
    if (key.isEmpty())
        return tr("Give the study a key.");
    if (!isShortName(key))
        return tr("Use only lower-case letters, digits and _, and begin with a letter.");
    return m_keys.contains(key) ? tr("Another study has this key. Choose another.") : QString();
}

void NewStudyDialog::showFault(QLineEdit* field, QLabel* words, const QString& fault) {
    words->setText(fault);
    words->setVisible(!fault.isEmpty());
    field->setAccessibleDescription(fault);
    form::setKind(field, fault.isEmpty() ? "" : "bad");
}

void NewStudyDialog::renew() {
    if (!chosen()) { // nothing is chosen, or templates are still loading
        setAcceptable(false, m_templates.empty() ? tr("The templates are being read.")
                                                 : tr("Choose what to begin with first."));
        return;
    }
    showFault(m_title, m_titleFault, titleFault());
    showFault(m_key, m_keyFault, keyFault());
    setAcceptable(titleFault().isEmpty() && keyFault().isEmpty(),
                  titleFault().isEmpty() ? keyFault() : titleFault());
}

void NewStudyDialog::submit() {
    setWorking(true);
    psychophysics::StudyDesign design = *chosen();
    design.id = m_key->text().toStdString();
    const std::string title = m_title->text().trimmed().toStdString();
    if (design.title.at("en") != title)
        // The template's titles in other languages would describe another study.
        design.title = {{"en", title}};
    renewInstructions(design);
    writeStudies(
        context(), this,
        [design](database::StudyRepository& studies) {
            return studies.createStudy(design.id, design.title.at("en"),
                                       catalogue::studyJson(design).toStdString());
        },
        [this](const core::Result<database::StudyNumber>& study) {
            setWorking(false);
            if (!study) {
                say("bad", tr("The study was not created. Its key may already be in use.\n%1")
                               .arg(inWords(study.error())));
                return;
            }
            emit created(*study);
            accept();
        });
}

} // namespace chiron::desktop
