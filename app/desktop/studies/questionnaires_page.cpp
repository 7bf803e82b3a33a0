// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/questionnaires_page.h"

#include "desktop/frame/app_context.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"

#include <QBoxLayout>
#include <QMenu>
#include <QPushButton>
#include <algorithm>

namespace chiron::desktop {

using namespace psychophysics;

namespace {

QString kindInWords(QuestionnaireItem::Kind kind) {
    switch (kind) {
    case QuestionnaireItem::Kind::likert:
        return QuestionnairesPage::tr("Scale with labelled ends");
    case QuestionnaireItem::Kind::number:
        return QuestionnairesPage::tr("Number");
    case QuestionnaireItem::Kind::choice:
        return QuestionnairesPage::tr("Choice");
    case QuestionnaireItem::Kind::text:
        return QuestionnairesPage::tr("Free text");
    }
    return {};
}

QuestionnaireItem usualItem(std::size_t number) {
    QuestionnaireItem item;
    item.id = "question_" + std::to_string(number);
    item.text["en"] = "How real did it feel?";
    item.low["en"] = "not at all";
    item.high["en"] = "completely";
    item.construct = "face";
    return item;
}

/// Locates a text of an item in a design.
std::function<StudyText&(StudyDesign&)> textOf(std::size_t index, std::size_t item,
                                               StudyText QuestionnaireItem::*member) {
    return
        [=](StudyDesign& design) -> StudyText& { return design.questionnaires[index].items[item].*member; };
}

} // namespace

QuestionnairesPage::QuestionnairesPage(const DesignPage& page, QWidget* parent)
    : QWidget(parent), m_page(page) {
    const Theme& theme = page.app.theme();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(16));
    const std::size_t count = page.draft.design().questionnaires.size();
    if (count == 0)
        column->addWidget(kit::label(
            theme,
            tr("No questionnaires. Each participant answers a questionnaire once, before or after the "
               "runs, or after each condition. The answers are stored with the data."),
            TextStyle::body, "muted"));
    for (std::size_t i = 0; i < count; ++i)
        column->addWidget(questionnaireBox(i));
    if (!page.readOnly)
        column->addWidget(addButtons(count == 0));
    column->addStretch();
}

QWidget* QuestionnairesPage::addButtons(bool first) {
    const Theme& theme = m_page.app.theme();
    auto* bar = new QWidget;
    auto* row = new FlowLayout(theme.px(8), bar);
    auto* add =
        kit::button(theme, tr("Add a questionnaire"), first ? "primary" : "", QStringLiteral("list-add"));
    add->setObjectName(QStringLiteral("questionnaires.add"));
    connect(add, &QPushButton::clicked, this, &QuestionnairesPage::addQuestionnaire);
    row->addWidget(add);
    auto* instrument =
        kit::button(theme, tr("Add a published questionnaire …"), "", QStringLiteral("list-add"));
    instrument->setObjectName(QStringLiteral("questionnaires.instrument"));
    instrument->setToolTip(tr("Published questionnaires with their scores, and what is written down when a "
                              "participant is enrolled"));
    connect(instrument, &QPushButton::clicked, this, &QuestionnairesPage::chooseInstrument);
    row->addWidget(instrument);
    return bar;
}

void QuestionnairesPage::chooseInstrument() {
    const auto instruments = catalogue::loadInstruments();
    if (!instruments) {
        m_page.app.messages().error(tr("The published questionnaires could not be read."),
                                    instruments.error(), Tried::reading);
        return;
    }
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("questionnaires.instruments"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    const auto& there = m_page.draft.design().questionnaires;
    for (const catalogue::Instrument& instrument : *instruments) {
        QAction* action =
            menu->addAction(study_words::text(instrument.questionnaire.title, m_page.app.language()));
        action->setObjectName(QStringLiteral("questionnaires.instrument.%1")
                                  .arg(QString::fromStdString(instrument.questionnaire.id)));
        action->setToolTip(QString::fromStdString(instrument.source + "\n" + instrument.permission));
        action->setEnabled(std::none_of(there.begin(), there.end(), [&](const Questionnaire& each) {
            return each.id == instrument.questionnaire.id;
        }));
        connect(action, &QAction::triggered, this, [this, instrument] { addInstrument(instrument); });
    }
    const auto* button = findChild<QPushButton*>(QStringLiteral("questionnaires.instrument"));
    menu->popup(button->mapToGlobal(QPoint(0, button->height())));
}

void QuestionnairesPage::addInstrument(const catalogue::Instrument& instrument) {
    m_page.draft.change(
        tr("Add a published questionnaire"), {},
        [&](StudyDesign& design) { design.questionnaires.push_back(instrument.questionnaire); }, true);
}

void QuestionnairesPage::addQuestionnaire() {
    m_page.draft.change(
        tr("Add a questionnaire"), {},
        [](StudyDesign& design) {
            Questionnaire added;
            added.id = "questionnaire_" + std::to_string(design.questionnaires.size() + 1);
            added.title["en"] = "Questionnaire";
            added.items = {usualItem(1)};
            design.questionnaires.push_back(std::move(added));
        },
        true);
}

QPushButton* QuestionnairesPage::action(const QString& text, const char* icon, const QString& name,
                                        const std::function<void(StudyDesign&)>& edit) {
    auto* button = kit::button(m_page.app.theme(), text, "quiet", QLatin1String(icon));
    button->setObjectName(name);
    connect(button, &QPushButton::clicked, this,
            [this, text, edit] { m_page.draft.change(text, {}, edit, true); });
    return button;
}

/// `told` is asked before the part is removed.
QPushButton* QuestionnairesPage::removal(const QString& text, const QString& name,
                                         const std::function<QString()>& told,
                                         const std::function<void(StudyDesign&)>& edit) {
    auto* button = kit::button(m_page.app.theme(), text, "quiet", QStringLiteral("edit-delete"));
    button->setObjectName(name);
    connect(button, &QPushButton::clicked, this, [this, text, told, edit] {
        const QString removed = told();
        m_page.draft.change(text, {}, edit, true);
        tellRemoved(m_page, removed);
    });
    return button;
}

QWidget* QuestionnairesPage::questionnaireBox(std::size_t index) {
    const Theme& theme = m_page.app.theme();
    const Questionnaire& shown = m_page.draft.design().questionnaires[index];
    const QString prefix = QStringLiteral("questionnaire.%1.").arg(index);
    const kit::Box box = kit::box(theme);
    auto* grid = new FieldGrid(theme, m_page.app.locale(), m_page.readOnly);
    addStudyText(*grid, m_page, tr("Title of the questionnaire"), prefix + QStringLiteral("title"), 1,
                 [index](StudyDesign& design) -> StudyText& { return design.questionnaires[index].title; });
    grid->text(tr("Id"), prefix + QStringLiteral("id"), QString::fromStdString(shown.id),
               [this, index, prefix](const QString& now) {
                   m_page.draft.change(tr("Id of a questionnaire"), prefix + QStringLiteral("id"),
                                       [&](StudyDesign& design) {
                                           design.questionnaires[index].id = now.trimmed().toStdString();
                                       });
               });
    grid->choice(tr("Answered"), prefix + QStringLiteral("when"),
                 {{tr("before the runs"), static_cast<int>(Questionnaire::When::before)},
                  {tr("after the runs"), static_cast<int>(Questionnaire::When::after)},
                  {tr("after each condition, about that condition"),
                   static_cast<int>(Questionnaire::When::afterCondition)},
                  {tr("when a participant is enrolled"), static_cast<int>(Questionnaire::When::enrolment)}},
                 static_cast<int>(shown.when), [this, index](const QVariant& now) {
                     m_page.draft.change(tr("When it is answered"), {}, [&](StudyDesign& design) {
                         design.questionnaires[index].when = static_cast<Questionnaire::When>(now.toInt());
                     });
                 });
    box.layout->addWidget(grid);
    for (std::size_t i = 0; i < shown.items.size(); ++i) {
        box.layout->addWidget(kit::rule());
        box.layout->addWidget(itemPart(index, i));
    }
    if (!m_page.readOnly) {
        auto* bar = new QWidget;
        auto* row = new FlowLayout(theme.px(8), bar);
        row->addWidget(action(tr("Add a question"), "list-add", prefix + QStringLiteral("add"),
                              [index](StudyDesign& design) {
                                  std::vector<QuestionnaireItem>& items = design.questionnaires[index].items;
                                  items.push_back(usualItem(items.size() + 1));
                              }));
        const auto told = [this, index] {
            const Questionnaire& removed = m_page.draft.design().questionnaires[index];
            return tr("The questionnaire “%1” was removed.")
                .arg(study_words::text(removed.title, m_page.app.language()));
        };
        row->addWidget(removal(tr("Remove the questionnaire"), prefix + QStringLiteral("remove"), told,
                               [index](StudyDesign& design) {
                                   design.questionnaires.erase(design.questionnaires.begin() +
                                                               static_cast<std::ptrdiff_t>(index));
                               }));
        box.layout->addWidget(bar);
    }
    return box.frame;
}

QWidget* QuestionnairesPage::itemPart(std::size_t index, std::size_t item) {
    const QuestionnaireItem& shown = m_page.draft.design().questionnaires[index].items[item];
    const QString prefix = QStringLiteral("item.%1.%2.").arg(index).arg(item);
    auto* grid = new FieldGrid(m_page.app.theme(), m_page.app.locale(), m_page.readOnly);
    const auto edit = [this, index, item](const QString& key, bool structure,
                                          const std::function<void(QuestionnaireItem&)>& change) {
        m_page.draft.change(
            tr("Change of a question"), key,
            [&](StudyDesign& design) { change(design.questionnaires[index].items[item]); }, structure);
    };
    addStudyText(*grid, m_page, tr("Question %1").arg(item + 1), prefix + QStringLiteral("text"), 2,
                 textOf(index, item, &QuestionnaireItem::text));
    std::vector<std::pair<QString, QVariant>> kinds;
    for (int kind = 0; kind <= static_cast<int>(QuestionnaireItem::Kind::text); ++kind)
        kinds.emplace_back(kindInWords(static_cast<QuestionnaireItem::Kind>(kind)), kind);
    grid->choice(tr("Answer"), prefix + QStringLiteral("kind"), kinds, static_cast<int>(shown.kind),
                 [edit](const QVariant& now) {
                     edit({}, true, [&](QuestionnaireItem& changed) {
                         changed.kind = static_cast<QuestionnaireItem::Kind>(now.toInt());
                     });
                 });
    grid->text(tr("Summarised under"), prefix + QStringLiteral("construct"),
               QString::fromStdString(shown.construct), [edit, prefix](const QString& now) {
                   edit(prefix + QStringLiteral("construct"), false,
                        [&](QuestionnaireItem& changed) { changed.construct = now.trimmed().toStdString(); });
               });
    if (shown.kind == QuestionnaireItem::Kind::likert) {
        grid->whole(tr("Steps"), prefix + QStringLiteral("scale"), shown.scale, 2, 21,
                    [edit, prefix](int now) {
                        edit(prefix + QStringLiteral("scale"), false,
                             [now](QuestionnaireItem& changed) { changed.scale = now; });
                    });
        addStudyText(*grid, m_page, tr("Label at low end"), prefix + QStringLiteral("low"), 1,
                     textOf(index, item, &QuestionnaireItem::low));
        addStudyText(*grid, m_page, tr("Label at high end"), prefix + QStringLiteral("high"), 1,
                     textOf(index, item, &QuestionnaireItem::high));
    } else if (shown.kind == QuestionnaireItem::Kind::number) {
        const auto bound = [&](const QString& label, const char* key, double QuestionnaireItem::*member) {
            grid->number(label, prefix + QLatin1String(key), shown.*member, {-1e6, 1e6, 2, {}, 1},
                         [edit, name = prefix + QLatin1String(key), member](double now) {
                             edit(name, false, [=](QuestionnaireItem& changed) { changed.*member = now; });
                         });
        };
        bound(tr("Minimum"), "lowest", &QuestionnaireItem::lowest);
        bound(tr("Maximum"), "highest", &QuestionnaireItem::highest);
    } else if (shown.kind == QuestionnaireItem::Kind::choice) {
        QStringList lines;
        for (const StudyText& choice : shown.choices) {
            const auto found = choice.find(m_page.language.toStdString());
            lines << (found == choice.end() ? QString() : QString::fromStdString(found->second));
        }
        grid->longText(
            tr("Choices, one per line"), prefix + QStringLiteral("choices"), lines.join(QLatin1Char('\n')), 4,
            [edit, prefix, language = m_page.language.toStdString()](const QString& now) {
                edit(prefix + QStringLiteral("choices"), false, [&](QuestionnaireItem& changed) {
                    const QStringList words = now.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
                    changed.choices.resize(static_cast<std::size_t>(words.size()));
                    for (std::size_t i = 0; i < changed.choices.size(); ++i)
                        changed.choices[i][language] = words[static_cast<qsizetype>(i)].toStdString();
                });
            });
    }
    grid->check(tr("Must be answered"), prefix + QStringLiteral("required"), shown.required,
                [edit, prefix](bool now) {
                    edit(prefix + QStringLiteral("required"), false,
                         [now](QuestionnaireItem& changed) { changed.required = now; });
                });
    if (!m_page.readOnly) {
        QPushButton* remove = removal(
            tr("Remove question %1").arg(item + 1), prefix + QStringLiteral("remove"),
            [item] { return tr("Question %1 was removed.").arg(item + 1); },
            [index, item](StudyDesign& design) {
                std::vector<QuestionnaireItem>& items = design.questionnaires[index].items;
                items.erase(items.begin() + static_cast<std::ptrdiff_t>(item));
            });
        auto* row = new QWidget; // left-aligned, where the fields begin
        auto* line = new QHBoxLayout(row);
        line->setContentsMargins(0, 0, 0, 0);
        line->addWidget(remove);
        line->addStretch();
        grid->wide(row);
    }
    return grid;
}

} // namespace chiron::desktop
