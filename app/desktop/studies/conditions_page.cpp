// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/conditions_page.h"

#include "catalogue/study_json.h"

#include "desktop/frame/app_context.h"
#include "desktop/studies/attribute_names.h"
#include "desktop/studies/difference_table.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/procedure_form.h"
#include "desktop/studies/study_titles.h"
#include "desktop/studies/study_words.h"
#include "desktop/studies/text_claims.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "psychophysics/procedures/procedure_catalogue.h"
#include "session/study/presentation_order.h"

#include <QLineEdit>
#include <QRegularExpression>
#include <algorithm>
#include <memory>
#include <set>

namespace chiron::desktop {

using namespace psychophysics;

ConditionsPage::ConditionsPage(const DesignPage& page, int shown, QWidget* parent)
    : QWidget(parent), m_page(page),
      m_shown(
          std::clamp(shown, 0, std::max(0, static_cast<int>(page.draft.design().conditions.size()) - 1))) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(page.app.theme().px(16));
    if (page.masked) {
        column->addWidget(sealedBox());
        if (page.blinding.analysable()) {
            column->addWidget(sharedBox());
            column->addWidget(proceduresBox());
        }
        column->addStretch();
        return;
    }
    column->addWidget(chooser());
    if (!page.draft.design().conditions.empty()) {
        column->addWidget(stimulusBox());
        // In a study with one condition, the study's own instructions suffice.
        if (!condition().instructions.empty() ||
            (!page.readOnly && page.draft.design().conditions.size() > 1))
            column->addWidget(instructionsBox());
        if (!apex())
            column->addWidget(tableBox());
        column->addWidget(proceduresBox());
    }
    column->addStretch();
}

QWidget* ConditionsPage::sealedBox() {
    const Theme& theme = m_page.app.theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Sealed conditions"), TextStyle::title));
    QStringList codes;
    for (const Condition& each : m_page.draft.design().conditions)
        codes << study_words::text(each.title, m_page.app.language());
    auto* label = kit::label(theme, codes.join(QStringLiteral(" · ")), TextStyle::heading);
    label->setObjectName(QStringLiteral("conditions.codes"));
    box.layout->addWidget(label);
    box.layout->addWidget(kit::label(
        theme,
        tr("The study is blind: until it is unblinded, its conditions are shown only by these codes "
           "and their differences are hidden. Only the study's author and administrators see the "
           "design."),
        TextStyle::body, "muted"));
    return box.frame;
}

QWidget* ConditionsPage::sharedBox() {
    const Theme& theme = m_page.app.theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("What the conditions have in common"), TextStyle::title));
    auto* grid = new FieldGrid(theme, m_page.app.locale(), true);
    const auto fact = [&](const QString& name, const QString& value) {
        auto* part = new QWidget;
        auto* column = new QVBoxLayout(part);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        column->addWidget(kit::label(theme, value, TextStyle::strong));
        column->addWidget(kit::label(theme, name, TextStyle::small, "muted"));
        grid->cell(part);
    };
    const StimulusDesign& stimulus = condition().stimulus;
    const QLocale locale = m_page.app.locale();
    if (m_page.blinding.oneStimulus) {
        fact(tr("Attribute"), study_words::attribute(stimulus.attribute));
        fact(tr("Reference"), study_words::value(stimulus.reference, stimulus.attribute, locale));
    }
    fact(tr("Task"), study_words::task(condition().task));
    fact(tr("Candidates"), locale.toString(static_cast<int>(stimulus.differences.size())));
    const QStringList ends = study_words::percents({study_words::ratioOf(stimulus.differences.front()),
                                                    study_words::ratioOf(stimulus.differences.back())},
                                                   locale);
    fact(tr("Differences from the reference"), tr("%1 to %2").arg(ends.front(), ends.back()));
    grid->wide(kit::label(theme, study_words::taskInWords(condition().task), TextStyle::small, "muted"));
    box.layout->addWidget(grid);
    return box.frame;
}

const Condition& ConditionsPage::condition() const {
    return m_page.draft.design().conditions[static_cast<std::size_t>(m_shown)];
}

void ConditionsPage::edit(const QString& words, const QString& key,
                          const std::function<void(Condition&)>& change, bool structure) {
    m_page.draft.change(
        words, key.isEmpty() ? key : QStringLiteral("%1.%2").arg(m_shown).arg(key),
        [&](StudyDesign& design) { change(design.conditions[static_cast<std::size_t>(m_shown)]); },
        structure);
}

QString ConditionsPage::buttonText(const Condition& condition) const {
    const QString title = study_words::text(condition.title, m_page.app.language());
    return title.isEmpty() ? QString::fromStdString(condition.id) : title;
}

QWidget* ConditionsPage::chooser() {
    const Theme& theme = m_page.app.theme();
    auto* bar = new QWidget;
    auto* row = new FlowLayout(theme.px(8), bar);
    const std::vector<Condition>& conditions = m_page.draft.design().conditions;
    for (std::size_t i = 0; i < conditions.size(); ++i) {
        auto* button = kit::button(theme, buttonText(conditions[i]));
        button->setObjectName(QStringLiteral("conditions.%1").arg(i));
        button->setCheckable(true);
        button->setChecked(static_cast<int>(i) == m_shown);
        connect(button, &QPushButton::clicked, this, [this, i] { emit showAsked(static_cast<int>(i)); });
        row->addWidget(button);
    }
    // A newly typed title appears on the button at once.
    connect(&m_page.draft, &StudyDraft::changed, bar, [this, bar] {
        const auto& now = m_page.draft.design().conditions;
        for (std::size_t i = 0; i < now.size(); ++i)
            if (auto* button = bar->findChild<QPushButton*>(QStringLiteral("conditions.%1").arg(i)))
                button->setText(buttonText(now[i]));
    });
    if (m_page.readOnly)
        return bar;
    const auto add = [&](const QString& text, const char* icon, const char* name,
                         const std::function<void()>& act) {
        auto* button = kit::button(theme, text, "quiet", QLatin1String(icon));
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, act);
        row->addWidget(button);
        return button;
    };
    add(tr("Add a condition"), "list-add", "conditions.copy", [this] { addCondition(); });
    add(tr("Remove"), "edit-delete", "conditions.remove", [this] {
        removeCondition();
    })->setEnabled(conditions.size() > 1);
    return bar;
}

namespace {

/// "Tube (2)": a title that no other condition has in this language.
std::string freeTitle(const StudyDesign& design, const std::string& language, const std::string& title) {
    const auto taken = [&](const std::string& wanted) {
        return std::any_of(design.conditions.begin(), design.conditions.end(), [&](const Condition& each) {
            const auto found = each.title.find(language);
            return found != each.title.end() && found->second == wanted;
        });
    };
    for (int n = 2;; ++n)
        if (const std::string wanted = title + " (" + std::to_string(n) + ")"; !taken(wanted))
            return wanted;
}

} // namespace

void ConditionsPage::addCondition() {
    m_page.draft.change(
        tr("Add a condition"), {},
        [this](StudyDesign& design) {
            Condition copy = design.conditions[static_cast<std::size_t>(m_shown)];
            const std::string base = copy.id;
            for (int n = 2; std::any_of(design.conditions.begin(), design.conditions.end(),
                                        [&](const Condition& each) { return each.id == copy.id; });
                 ++n)
                copy.id = base + "_" + std::to_string(n);
            for (auto& [language, words] : copy.title)
                words = freeTitle(design, language, words);
            copy.instructions.clear(); // instructions rarely fit another condition
            design.conditions.push_back(std::move(copy));
        },
        true);
    emit showAsked(static_cast<int>(m_page.draft.design().conditions.size()) - 1);
}

void ConditionsPage::removeCondition() {
    const QString removed = buttonText(condition());
    m_page.draft.change(
        tr("Remove a condition"), {},
        [this](StudyDesign& design) { design.conditions.erase(design.conditions.begin() + m_shown); }, true);
    tellRemoved(m_page, tr("The condition “%1” was removed.").arg(removed));
}

bool ConditionsPage::apex() const {
    return condition().stimulus.attribute == Attribute::apex;
}

QWidget* ConditionsPage::stimulusBox() {
    const Theme& theme = m_page.app.theme();
    const kit::Box box = titledBox(theme, apex() ? tr("What is looked for") : tr("What is compared"));
    auto* grid = new FieldGrid(theme, m_page.app.locale(), m_page.readOnly);
    addNames(*grid);
    std::vector<std::pair<QString, QVariant>> attributes;
    for (int i = 0; i < kAttributes; ++i)
        attributes.emplace_back(study_words::attribute(static_cast<Attribute>(i)), i);
    grid->choice(tr("Attribute"), QStringLiteral("condition.attribute"), attributes,
                 static_cast<int>(condition().stimulus.attribute), [this](const QVariant& now) {
                     m_page.draft.change(
                         tr("Change of the attribute"), {},
                         [&](StudyDesign& design) {
                             const auto at = static_cast<std::size_t>(m_shown);
                             const StimulusDesign before = design.conditions[at].stimulus;
                             takeAttribute(design.conditions[at], static_cast<Attribute>(now.toInt()));
                             nameByAttribute(
                                 design, at, before.attribute, before.reference,
                                 [this](const std::string& name) { return m_page.draft.isKeptName(name); });
                         },
                         true);
                 });
    grid->explain(QStringLiteral("condition.attribute"),
                  tr("The only property in which the objects differ."));
    addReference(*grid);
    if (!apex())
        addTask(*grid);
    box.layout->addWidget(grid);
    if (!m_page.readOnly)
        box.layout->addWidget(claimsNotice(m_page, FalseClaim::Where::title, m_shown));
    return box.frame;
}

QWidget* ConditionsPage::instructionsBox() {
    const Theme& theme = m_page.app.theme();
    const kit::Box box = titledBox(theme, tr("What is different for the participant"));
    auto* grid = new FieldGrid(theme, m_page.app.locale(), m_page.readOnly);
    const QString name = QStringLiteral("condition.instructions");
    addStudyText(
        *grid, m_page, tr("What participants read before this condition"), name, 2,
        [at = static_cast<std::size_t>(m_shown)](StudyDesign& design) -> StudyText& {
            return design.conditions[at].instructions;
        },
        true);
    grid->explain(name, tr("What the settings do not say, such as \"Put on the glove.\" or \"Use your other "
                           "hand.\" Leave it empty if nothing is different. "
                           "Whoever reads it can tell this condition from the others."));
    box.layout->addWidget(grid);
    if (!m_page.readOnly)
        box.layout->addWidget(claimsNotice(m_page, FalseClaim::Where::part, m_shown));
    return box.frame;
}

namespace {

/// The title that short names are made of.
QString englishTitle(const Condition& condition) {
    const auto found = condition.title.find("en");
    return found == condition.title.end() ? QString() : QString::fromStdString(found->second);
}

/// Makes the short name of a condition anew from its title; no other condition has it.
void nameByTitle(StudyDesign& design, std::size_t at) {
    const QString wanted = shortNameOf(englishTitle(design.conditions[at]));
    if (wanted.isEmpty())
        return; // the title is just being typed anew
    std::set<QString> taken;
    for (std::size_t i = 0; i < design.conditions.size(); ++i)
        if (i != at)
            taken.insert(QString::fromStdString(design.conditions[i].id));
    design.conditions[at].id = freeShortName(wanted, taken).toStdString();
}

} // namespace

/// Whether the short name was made of the title and not typed.
bool ConditionsPage::nameFollowsTitle() const {
    const std::string& id = condition().id;
    return !m_page.draft.isKeptName(id) && isMadeOf(QString::fromStdString(id), englishTitle(condition()));
}

void ConditionsPage::addNames(FieldGrid& grid) {
    const auto at = static_cast<std::size_t>(m_shown);
    // Decided once: a title that is being typed anew is empty for a moment, and nothing is made of it.
    const auto follows = std::make_shared<bool>(nameFollowsTitle());
    addStudyText(
        grid, m_page, tr("Title"), QStringLiteral("condition.title"), 1,
        [at](StudyDesign& design) -> StudyText& { return design.conditions[at].title; }, false,
        [at, follows, &draft = m_page.draft,
         english = m_page.language == QStringLiteral("en")](StudyDesign& design) {
            if (english)
                draft.keepName(englishTitle(design.conditions[at]).toStdString());
            if (*follows && english)
                nameByTitle(design, at);
        });
    grid.explain(QStringLiteral("condition.title"),
                 tr("What the condition is called in tables and figures. Participants never see it."));
    connect(qobject_cast<QLineEdit*>(grid.field(QStringLiteral("condition.title"))), &QLineEdit::textEdited,
            this, [this, grid = &grid] { showNames(*grid); });
    grid.text(tr("Short name in exports"), QStringLiteral("condition.id"),
              QString::fromStdString(condition().id), [this, follows](const QString& now) {
                  const std::string id = now.trimmed().toStdString();
                  *follows = id.empty();
                  if (!id.empty())
                      m_page.draft.keepName(id);
                  edit(tr("Id of a condition"), QStringLiteral("id"),
                       [&](Condition& changed) { changed.id = id; });
              });
    grid.explain(QStringLiteral("condition.id"),
                 tr("Lower-case letters, digits and _ only; each condition needs a different one. It follows "
                    "the English title until somebody types a name."));
}

namespace {

const QRegularExpression& numberOfCopy() {
    static const QRegularExpression kCopy(QStringLiteral("\\s\\(\\d+\\)$"));
    return kCopy;
}

/// Whether no condition but the one at `at` has this title in this language.
bool isFreeTitle(const StudyDesign& design, std::size_t at, const std::string& language,
                 const std::string& title) {
    for (std::size_t i = 0; i < design.conditions.size(); ++i)
        if (const auto found = design.conditions[i].title.find(language);
            i != at && found != design.conditions[i].title.end() && found->second == title)
            return false;
    return true;
}

QString withValue(const QString& title, double value, const QString& unit) {
    return QStringLiteral("%1, %2 %3").arg(title, QString::number(value, 'g', 6), unit).trimmed();
}

/// "Mass (2)", the title of a copy, says in what the copy differs once its reference does: it becomes
/// "Mass, 100 g", and "Mass", the one that it was copied from, becomes "Mass, 50 g" unless somebody typed it.
/// In each language; titles that are no copy's stay as they are.
void nameCopyByValue(StudyDesign& design, std::size_t at, double value,
                     const std::function<bool(const std::string&)>& isTyped) {
    const study_words::Unit unit = study_words::unitOf(design.conditions[at].stimulus.attribute);
    const QRegularExpression told(QStringLiteral("(?<![0-9.,])%1\\s*%2")
                                      .arg(QRegularExpression::escape(QString::number(value, 'g', 6)),
                                           QRegularExpression::escape(unit.text)));
    for (auto& [language, words] : design.conditions[at].title) {
        const QString title = QString::fromStdString(words);
        if (!title.contains(numberOfCopy()) || title.contains(told) || isTyped(words))
            continue;
        const QString plain = QString(title).remove(numberOfCopy());
        const std::string named = withValue(plain, value, unit.text).toStdString();
        if (!isFreeTitle(design, at, language, named))
            continue;
        words = named;
        for (std::size_t i = 0; i < design.conditions.size(); ++i) {
            Condition& other = design.conditions[i];
            const auto same = other.title.find(language);
            if (i == at || same == other.title.end() || same->second != plain.toStdString() ||
                other.stimulus.attribute != design.conditions[at].stimulus.attribute || isTyped(same->second))
                continue;
            const bool idFollows =
                language == "en" && !isTyped(other.id) && isMadeOf(QString::fromStdString(other.id), plain);
            same->second = withValue(plain, other.stimulus.reference * unit.factor, unit.text).toStdString();
            if (idFollows)
                nameByTitle(design, i);
        }
    }
}

/// Updates names that contain the reference value: "Tube of 60 N/m (2)" becomes "Tube of 120 N/m", and
/// "tube_60_2" becomes "tube_120", as "sphere_20mm" becomes "sphere_30mm". A short name without the value
/// follows the title if it is made of it (`followsTitle`). Other names stay as they are, but for a copy's
/// (nameCopyByValue).
void nameByReference(StudyDesign& design, std::size_t at, double before, double after, const QString& unit,
                     bool followsTitle, const std::function<bool(const std::string&)>& isTyped) {
    Condition& changed = design.conditions[at];
    const QString titleBefore = englishTitle(changed);
    const auto isFree = [&](const auto& isIts) {
        for (std::size_t i = 0; i < design.conditions.size(); ++i)
            if (i != at && isIts(design.conditions[i]))
                return false;
        return true;
    };
    const QString was = QString::number(before, 'g', 6), now = QString::number(after, 'g', 6);
    if (!unit.isEmpty()) {
        const QRegularExpression value(
            QStringLiteral("(?<![0-9.,])%1(\\s*)%2(?![\\w/])")
                .arg(QRegularExpression::escape(was), QRegularExpression::escape(unit)),
            QRegularExpression::UseUnicodePropertiesOption);
        for (auto& [language, words] : changed.title) {
            QString title = QString::fromStdString(words);
            if (!title.contains(value))
                continue;
            title.replace(value, now + QStringLiteral("\\1") + unit);
            const std::string plain = QString(title).remove(numberOfCopy()).toStdString();
            words = isFreeTitle(design, at, language, plain) ? plain : title.toStdString();
        }
    }
    if (before != after)
        nameCopyByValue(design, at, after, isTyped);
    static const QRegularExpression kNoKey(QStringLiteral("[^a-z0-9]+"));
    const auto key = [](QString number) { return number.replace(kNoKey, QStringLiteral("_")); };
    const QRegularExpression id(QStringLiteral("^(.*_)%1((?:_?%2)?)(_\\d+)?$")
                                    .arg(QRegularExpression::escape(key(was)), key(unit.toLower())));
    if (const auto match = id.match(QString::fromStdString(changed.id)); match.hasMatch()) {
        const QString plain = match.captured(1) + key(now) + match.captured(2);
        const bool mine = isFree([&](const Condition& other) { return other.id == plain.toStdString(); });
        changed.id = (mine ? plain : plain + match.captured(3)).toStdString();
    } else if (followsTitle && englishTitle(changed) != titleBefore) {
        nameByTitle(design, at);
    }
}

} // namespace

/// Updates the name fields above the reference after names have followed it.
void ConditionsPage::showNames(FieldGrid& grid) const {
    const auto put = [&grid](const char* name, const QString& words) {
        auto* field = qobject_cast<QLineEdit*>(grid.field(QLatin1String(name)));
        if (field && field->text() != words)
            field->setText(words);
    };
    const auto title = condition().title.find(m_page.language.toStdString());
    put("condition.title",
        title == condition().title.end() ? QString() : QString::fromStdString(title->second));
    put("condition.id", QString::fromStdString(condition().id));
}

void ConditionsPage::addReference(FieldGrid& grid) {
    const Attribute attribute = condition().stimulus.attribute;
    const study_words::Unit unit = study_words::unitOf(attribute);
    const catalogue::ValueRange range = catalogue::valueRange(attribute);
    grid.number(
        apex() ? tr("Radius of the sphere") : tr("Reference"), QStringLiteral("condition.reference"),
        condition().stimulus.reference * unit.factor, {0, 1e9, 4, unit.text, 1},
        [this, grid = &grid, unit](double now) {
            const bool followsTitle = nameFollowsTitle();
            m_page.draft.change(
                tr("Reference"), QStringLiteral("%1.reference").arg(m_shown), [&](StudyDesign& design) {
                    const auto at = static_cast<std::size_t>(m_shown);
                    nameByReference(design, at, design.conditions[at].stimulus.reference * unit.factor, now,
                                    unit.text, followsTitle, [this](const std::string& name) {
                                        return m_page.draft.isKeptName(name);
                                    });
                    design.conditions[at].stimulus.reference = now / unit.factor;
                });
            showNames(*grid);
        });
    grid.explain(
        QStringLiteral("condition.reference"),
        apex() ? tr("How large the sphere is whose highest point is looked for.")
               : tr("The object that the others are compared with."),
        {range.lowest * unit.factor, range.highest * unit.factor, usualReference(attribute) * unit.factor});
}

void ConditionsPage::addTask(FieldGrid& grid) {
    std::vector<std::pair<QString, QVariant>> tasks;
    for (int i = 0; i < kTasks; ++i)
        tasks.insert(static_cast<Task>(i) == Task::rank3Ties ? tasks.begin() + 1 : tasks.end(),
                     {study_words::task(static_cast<Task>(i)), i});
    grid.choice(tr("Task"), QStringLiteral("condition.task"), tasks, static_cast<int>(condition().task),
                [this](const QVariant& now) {
                    edit(
                        tr("Change of the task"), {},
                        [&](Condition& changed) { takeTask(changed, static_cast<Task>(now.toInt())); }, true);
                });
    grid.explain(QStringLiteral("condition.task"), study_words::taskInWords(condition().task));
    if (correctAnswer(condition().task, 0) < 0)
        return; // no answer is correct, so there is no proportion of correct answers
    constexpr double kPercent = 100.0;
    grid.number(tr("Threshold at"), QStringLiteral("condition.criterion"), kPercent * condition().criterion,
                {1, 99, 1, QStringLiteral("%"), 1}, [this](double now) {
                    edit(tr("Criterion"), QStringLiteral("criterion"),
                         [&](Condition& changed) { changed.criterion = now / kPercent; });
                });
    grid.explain(QStringLiteral("condition.criterion"),
                 tr("The threshold is the difference at which this share of the answers is right."),
                 {1, 99, 75});
}

QWidget* ConditionsPage::tableBox() {
    const Theme& theme = m_page.app.theme();
    const kit::Box box = titledBox(theme, tr("Table of differences"));
    box.layout->addWidget(
        kit::label(theme, tr("The differences from the reference that a procedure may choose from."),
                   TextStyle::body, "muted"));
    auto* table = new DifferenceTable(theme, m_page.app.locale(), m_page.readOnly, condition().stimulus,
                                      catalogue::takesBothSides(condition().task) &&
                                          condition().scale == ProcedureScale::difference);
    connect(table, &DifferenceTable::changed, this, [this](const std::vector<double>& differences) {
        edit(
            tr("Table of differences"), {},
            [&](Condition& changed) {
                changed.stimulus.differences = differences;
                for (ProcedureSpec& procedure : changed.procedures) // levels and grids follow the table
                    procedure = usualProcedureKeeping(std::string(kindOf(procedure)), changed, procedure);
            },
            true);
    });
    // The objects' values follow the reference.
    connect(&m_page.draft, &StudyDraft::changed, table, [this, table] {
        if (static_cast<std::size_t>(m_shown) < m_page.draft.design().conditions.size())
            table->showObjects(condition().stimulus);
    });
    box.layout->addWidget(table);
    return box.frame;
}

QWidget* ConditionsPage::proceduresBox() {
    const Theme& theme = m_page.app.theme();
    const kit::Box box = titledBox(theme, apex() ? tr("Trials") : tr("Procedure"));
    if (condition().procedures.size() > 1) {
        auto* words = kit::label(theme, {}, TextStyle::body, "muted");
        words->setObjectName(QStringLiteral("conditions.interleaved"));
        const auto show = [this, words] { // each form has the trials of its own procedure
            if (static_cast<std::size_t>(m_shown) >= m_page.draft.design().conditions.size())
                return;
            const QString said = tr("Several procedures are interleaved at random.");
            const int most = session::trialsAtMost(condition());
            words->setText(
                most > 0
                    ? said + QLatin1Char(' ') +
                          tr("Together they have at most %1 trials.").arg(m_page.app.locale().toString(most))
                    : said);
        };
        connect(&m_page.draft, &StudyDraft::changed, words, show);
        show();
        box.layout->addWidget(words);
    }
    if (hasScale())
        box.layout->addWidget(scaleGrid());
    for (std::size_t i = 0; i < condition().procedures.size(); ++i) {
        if (i > 0 || hasScale())
            box.layout->addWidget(kit::rule());
        box.layout->addWidget(new ProcedureForm(theme, m_page.app.locale(), m_page.readOnly, m_page.draft,
                                                {static_cast<std::size_t>(m_shown), i}));
    }
    if (!m_page.readOnly && !apex()) {
        auto* more =
            kit::button(theme, tr("Interleave another procedure"), "quiet", QStringLiteral("list-add"));
        more->setObjectName(QStringLiteral("conditions.more_procedures"));
        connect(more, &QPushButton::clicked, this, &ConditionsPage::addProcedure);
        auto* less =
            kit::button(theme, tr("Remove the last procedure"), "quiet", QStringLiteral("list-remove"));
        less->setObjectName(QStringLiteral("conditions.less_procedures"));
        less->setEnabled(condition().procedures.size() > 1);
        connect(less, &QPushButton::clicked, this, [this] {
            edit(
                tr("Remove a procedure"), {}, [](Condition& changed) { changed.procedures.pop_back(); },
                true);
            tellRemoved(m_page, tr("The last procedure of this condition was removed."));
        });
        auto* bar = new QWidget;
        auto* row = new FlowLayout(theme.px(8), bar);
        row->addWidget(more);
        row->addWidget(less);
        box.layout->addWidget(bar);
    }
    return box.frame;
}

/// Whether the procedure can work on the logarithm of a difference as well as on the difference.
bool ConditionsPage::hasScale() const {
    return !apex() && !ranksThree(condition().task) && condition().task != Task::adjustment &&
           condition().task != Task::magnitude;
}

QWidget* ConditionsPage::scaleGrid() {
    auto* scale = new FieldGrid(m_page.app.theme(), m_page.app.locale(), m_page.readOnly);
    scale->choice(
        tr("The procedure works on"), QStringLiteral("condition.scale"),
        {{study_words::scale(ProcedureScale::difference), static_cast<int>(ProcedureScale::difference)},
         {study_words::scale(ProcedureScale::logDifference),
          static_cast<int>(ProcedureScale::logDifference)}},
        static_cast<int>(condition().scale), [this](const QVariant& now) {
            edit(
                tr("Scale of the procedure"), {},
                [&](Condition& changed) {
                    changed.scale = static_cast<ProcedureScale>(now.toInt());
                    for (ProcedureSpec& procedure : changed.procedures)
                        procedure = usualProcedure(std::string(kindOf(procedure)), changed);
                },
                true);
        });
    scale->explain(QStringLiteral("condition.scale"),
                   tr("Ratios suit thresholds: from 2 % to 4 % is as far as from 10 % to 20 %. Differences "
                      "suit tables on both sides of the reference."));
    return scale;
}

void ConditionsPage::addProcedure() {
    edit(
        tr("Add a procedure"), {},
        [](Condition& changed) { changed.procedures.push_back(changed.procedures.back()); }, true);
}

} // namespace chiron::desktop
