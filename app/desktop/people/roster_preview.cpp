// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/roster_preview.h"

#include "desktop/people/people_model.h"
#include "desktop/people/roster_dialog.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QLocale>
#include <QTableWidget>
#include <algorithm>

namespace chiron::desktop {

namespace {

using Kind = database::RosterStep::Kind;

constexpr double kTableHeight = 240;
constexpr int kLoginNameColumn = 2;
constexpr int kFullNameColumn = 3;
constexpr int kMostDoubts = 5;     // lines of the summary
constexpr int kMostNames = 5;      // likewise
constexpr int kMeasuredRows = 100; // measuring a list of thousands would take too long

QString words(const char* text) {
    return QCoreApplication::translate("RosterWords", text);
}

QString counted(const char* text, int count) {
    return QCoreApplication::translate("RosterWords", text, nullptr, count);
}

QString delimiterWords(char delimiter) {
    switch (delimiter) {
    case ';':
        return words(QT_TRANSLATE_NOOP("RosterWords", "semicolons"));
    case ',':
        return words(QT_TRANSLATE_NOOP("RosterWords", "commas"));
    case '\t':
        return words(QT_TRANSLATE_NOOP("RosterWords", "tabs"));
    default:
        return QStringLiteral("“%1”").arg(QLatin1Char(delimiter));
    }
}

QString kindWords(Kind kind) {
    switch (kind) {
    case Kind::add:
        return words(QT_TRANSLATE_NOOP("RosterWords", "Would be added"));
    case Kind::skip:
        return words(QT_TRANSLATE_NOOP("RosterWords", "Would be left as it is"));
    case Kind::update:
        return words(QT_TRANSLATE_NOOP("RosterWords", "Would be updated"));
    case Kind::same:
        return words(QT_TRANSLATE_NOOP("RosterWords", "Nothing to change"));
    }
    return {};
}

QString rolesWords(const database::RoleSet& roles) {
    return rolesInWords(roles).join(QStringLiteral(", "));
}

/// "Bob → Robert" if the value changes.
QString change(bool changes, const QString& before, const QString& after) {
    return changes && before != after ? words(QT_TRANSLATE_NOOP("RosterWords", "%1 → %2")).arg(before, after)
                                      : after;
}

/// A remark on which person is meant; empty for most lines.
QString whoIsMeant(const database::RosterStep& step) {
    using Doubt = database::RosterStep::Doubt;
    const QString line = QLocale().toString(step.line);
    const QString name = QString::fromStdString(step.name);
    switch (step.doubt) {
    case Doubt::none:
        break;
    case Doubt::nameOfAnother:
        return words(QT_TRANSLATE_NOOP("RosterWords", "Line %1: the login name %2 belongs to %3 today; it "
                                                      "used to be that of %4. Check who is meant."))
            .arg(line, name,
                 QString::fromStdString(step.displayNameBefore.empty() ? step.name : step.displayNameBefore),
                 QString::fromStdString(step.other));
    case Doubt::severalHadIt:
        return words(
                   QT_TRANSLATE_NOOP("RosterWords",
                                     "Line %1: several people had the login name %2 before and nobody has it "
                                     "today, so nobody is changed. Write today's login name in the list."))
            .arg(line, name);
    case Doubt::sameAsLine:
        return words(QT_TRANSLATE_NOOP("RosterWords", "Line %1: this is the same person as in line %2, under "
                                                      "another login name. Only line %2 counts."))
            .arg(line, QLocale().toString(step.otherLine));
    }
    return {};
}

/// "bob, known as robert today".
QString loginNameWords(const database::RosterStep& step) {
    const QString name = QString::fromStdString(step.name);
    return step.earlierName.empty() ? name
                                    : words(QT_TRANSLATE_NOOP("RosterWords", "%1, known as %2 today"))
                                          .arg(QString::fromStdString(step.earlierName), name);
}

void addWhoIsMeant(QStringList& lines, const database::RosterPlan& plan) {
    const auto renamed = static_cast<int>(
        std::count_if(plan.steps.begin(), plan.steps.end(),
                      [](const database::RosterStep& step) { return !step.earlierName.empty(); }));
    if (renamed > 0)
        lines << counted(
            QT_TRANSLATE_N_NOOP("RosterWords",
                                "%n people are listed under an earlier login name and are recognised by it."),
            renamed);
    int doubts = 0;
    for (const database::RosterStep& step : plan.steps) {
        const QString doubt = whoIsMeant(step);
        if (doubt.isEmpty())
            continue;
        if (++doubts <= kMostDoubts)
            lines << doubt;
    }
    const int more = doubts - kMostDoubts;
    if (more > 0)
        lines << counted(QT_TRANSLATE_N_NOOP("RosterWords",
                                             "It is not certain who is meant in %n more lines. Point at "
                                             "the login name in the table to read why."),
                         more);
}

QString keepsFullNameWords(const database::RosterStep& step) {
    return words(
               QT_TRANSLATE_NOOP("RosterWords", "The list has the earlier full name %1; today's name stays."))
        .arg(QString::fromStdString(step.earlierDisplayName));
}

/// Lists the people whose full name would change, and those who keep theirs although the list contains
/// another one.
void addFullNames(QStringList& lines, const database::RosterPlan& plan) {
    int renamed = 0;
    for (const database::RosterStep& step : plan.steps) {
        if (step.kind != Kind::update || step.displayName == step.displayNameBefore)
            continue;
        if (++renamed <= kMostNames)
            lines << words(QT_TRANSLATE_NOOP("RosterWords", "%1 would be called %2."))
                         .arg(QString::fromStdString(step.displayNameBefore.empty() ? step.name
                                                                                    : step.displayNameBefore),
                              QString::fromStdString(step.displayName));
    }
    if (renamed > kMostNames)
        lines << counted(
            QT_TRANSLATE_N_NOOP("RosterWords",
                                "%n more people would get a different full name; the table shows them."),
            renamed - kMostNames);
    const auto kept = static_cast<int>(
        std::count_if(plan.steps.begin(), plan.steps.end(),
                      [](const database::RosterStep& step) { return !step.earlierDisplayName.empty(); }));
    if (kept > 0)
        lines << counted(
            QT_TRANSLATE_N_NOOP("RosterWords",
                                "%n people are listed under an earlier full name and keep today's name. To "
                                "give somebody an earlier name back, edit the person."),
            kept);
}

} // namespace

bool rosterLeavesDoubts(const database::RosterPlan& plan) {
    return std::any_of(plan.steps.begin(), plan.steps.end(), [](const database::RosterStep& step) {
        return step.doubt != database::RosterStep::Doubt::none;
    });
}

QString rosterReadWords(const database::Roster& roster) {
    return roster.encoding.empty()
               ? QString()
               : words(QT_TRANSLATE_NOOP("RosterWords", "Read as %1, separated by %2."))
                     .arg(QString::fromStdString(roster.encoding), delimiterWords(roster.delimiter));
}

QStringList rosterPlanWords(const database::RosterPlan& plan) {
    QStringList lines;
    const int added = plan.count(Kind::add);
    const int updated = plan.count(Kind::update);
    const int left = plan.count(Kind::skip) + plan.count(Kind::same);
    if (added > 0)
        lines << counted(
            QT_TRANSLATE_N_NOOP(
                "RosterWords",
                "%n people would be added. Each must choose a password of their own at the first login."),
            added);
    if (updated > 0)
        lines << counted(
            QT_TRANSLATE_N_NOOP("RosterWords", "%n people would be updated; their passwords remain valid."),
            updated);
    addFullNames(lines, plan);
    const auto lost = static_cast<int>(
        std::count_if(plan.steps.begin(), plan.steps.end(), [](const database::RosterStep& step) {
            return step.kind == Kind::update && step.rolesBefore.contains(database::Role::admin) &&
                   !step.roles.contains(database::Role::admin);
        }));
    if (lost > 0)
        lines << counted(QT_TRANSLATE_N_NOOP("RosterWords", "%n people would no longer be administrators."),
                         lost);
    const bool allHere = !plan.steps.empty() &&
                         std::none_of(plan.steps.begin(), plan.steps.end(),
                                      [](const database::RosterStep& step) { return step.person == 0; });
    if (added + updated == 0 && allHere)
        lines << words(
            QT_TRANSLATE_NOOP("RosterWords", "Nothing to import: everybody on the list is already here."));
    else if (left > 0)
        lines << counted(
            QT_TRANSLATE_N_NOOP("RosterWords",
                                "%n people have an account already and would be left as they are."),
            left);
    addWhoIsMeant(lines, plan);
    const auto made =
        static_cast<int>(std::count_if(plan.steps.begin(), plan.steps.end(),
                                       [](const database::RosterStep& step) { return step.makesPassword; }));
    if (made > 0)
        lines << counted(QT_TRANSLATE_N_NOOP("RosterWords",
                                             "%n passwords would be made. They are shown once, right after "
                                             "the import, to be printed as slips."),
                         made);
    if (!plan.roster.ignoredColumns.empty()) {
        QStringList titles;
        for (const std::string& title : plan.roster.ignoredColumns)
            titles << QString::fromStdString(title);
        lines << words(QT_TRANSLATE_NOOP("RosterWords", "Columns that are not imported: %1."))
                     .arg(titles.join(QStringLiteral(", ")));
    }
    return lines;
}

/// The errors in a line; empty if there are none.
QStringList problemsOf(const database::Roster& roster, int line) {
    QStringList told;
    for (const database::RosterProblem& problem : roster.problems)
        if (problem.line == line)
            told << rosterProblemWords(problem);
    return told;
}

QWidget* rosterTable(const Theme& theme, const database::RosterPlan& plan) {
    auto* table = new QTableWidget(static_cast<int>(plan.steps.size()), 5);
    table->setObjectName(QStringLiteral("roster.people"));
    table->setAccessibleName(words(QT_TRANSLATE_NOOP("RosterWords", "People in the list")));
    table->setHorizontalHeaderLabels({words(QT_TRANSLATE_NOOP("RosterWords", "Line")),
                                      words(QT_TRANSLATE_NOOP("RosterWords", "What happens")),
                                      words(QT_TRANSLATE_NOOP("RosterWords", "Login name")),
                                      words(QT_TRANSLATE_NOOP("RosterWords", "Full name")),
                                      words(QT_TRANSLATE_NOOP("RosterWords", "Roles"))});
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setTabKeyNavigation(false);
    table->verticalHeader()->hide();
    table->setMinimumHeight(theme.px(kTableHeight));
    int row = 0;
    for (const database::RosterStep& step : plan.steps) {
        const QStringList problems = problemsOf(plan.roster, step.line);
        const bool updates = step.kind == Kind::update && problems.isEmpty();
        const QString happens = problems.isEmpty()
                                    ? kindWords(step.kind)
                                    : words(QT_TRANSLATE_NOOP("RosterWords", "Cannot be imported yet"));
        const QString cells[] = {QLocale().toString(step.line), happens, loginNameWords(step),
                                 change(updates, QString::fromStdString(step.displayNameBefore),
                                        QString::fromStdString(step.displayName)),
                                 change(updates, rolesWords(step.rolesBefore), rolesWords(step.roles))};
        for (int column = 0; column < static_cast<int>(std::size(cells)); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            const QString doubt = whoIsMeant(step);
            item->setToolTip(!problems.isEmpty() ? problems.join(QLatin1Char('\n'))
                             : column == kLoginNameColumn && !doubt.isEmpty() ? doubt
                             : column == kFullNameColumn && !step.earlierDisplayName.empty()
                                 ? keepsFullNameWords(step)
                                 // The whole
                                 // text, in case
                                 // a small window
                                 // cuts it off.
                                 : cells[column]);
            table->setItem(row, column, item);
        }
        ++row;
    }
    table->horizontalHeader()->setResizeContentsPrecision(kMeasuredRows);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setStretchLastSection(true);
    return table;
}

} // namespace chiron::desktop
