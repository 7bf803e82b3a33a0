// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/roster_words.h"

#include "catalogue/language_words.h"

#include <QHash>
#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <algorithm>

namespace chiron::database {
namespace {

/// Returns the text in lower case without accents and punctuation: "Log-in_Name" and "LOG IN NAME" become
/// equal, as do "Ρόλος" and "ΡΟΛΟΣ".
QString plain(const QString& text) {
    QString words;
    for (const QChar c : text.normalized(QString::NormalizationForm_KD).toCaseFolded()) {
        if (!c.isMark()) {
            words += c.isLetterOrNumber() ? c : QLatin1Char(' ');
        }
    }
    return words.simplified();
}

struct Column {
    const char* key; ///< in the words of each language
    RosterColumn column;
};

constexpr Column kColumns[] = {
    {"some_name", RosterColumn::someName},       {"login_name", RosterColumn::loginName},
    {"display_name", RosterColumn::displayName}, {"given_name", RosterColumn::givenName},
    {"family_name", RosterColumn::familyName},   {"roles", RosterColumn::roles},
    {"password", RosterColumn::password},        {"group", RosterColumn::group},
};

RosterColumn columnOf(const std::string& heading) {
    static const QHash<QString, RosterColumn> known = [] {
        QHash<QString, RosterColumn> words;
        for (const catalogue::LanguageWords& language : catalogue::languageWords()) {
            for (const auto& [key, column] : kColumns) {
                for (const QString& word : language.roster.headings.at(QString::fromLatin1(key))) {
                    words.insert(plain(word), column);
                }
            }
        }
        return words;
    }();
    const QString words = plain(QString::fromStdString(heading));
    return words.isEmpty() ? RosterColumn::empty : known.value(words, RosterColumn::unknown);
}

/// A punctuation mark between a word and its ending is equivalent to a space: "Ausbilder/in", "Ausbilder:in",
/// "εκπαιδευτής/-τρια".
const QHash<QString, Role>& roleWords() {
    static const QHash<QString, Role> known = [] {
        QHash<QString, Role> words;
        for (const catalogue::LanguageWords& language : catalogue::languageWords()) {
            for (const Role role : kAllRoles) {
                for (const QString& name :
                     language.roster.roles.at(QString::fromStdString(std::string(token(role))))) {
                    words.insert(plain(name), role);
                }
            }
        }
        return words;
    }();
    return known;
}

QStringList wordsOf(const std::string& cell) {
    static const QRegularExpression separators(QStringLiteral("[;,|\\n]"));
    QStringList words;
    for (const QString& part : QString::fromStdString(cell).split(separators)) {
        if (!part.trimmed().isEmpty()) {
            words << part;
        }
    }
    return words;
}

/// Returns the meaning of a column "Name": beside "Vorname" it is the family name, beside "Επώνυμο" ("Όνομα")
/// the given name, beside "Login" the full name. Alone it is the login name.
RosterColumn meaningOfName(const std::vector<RosterColumn>& columns) {
    const auto has = [&](RosterColumn column) {
        return std::find(columns.begin(), columns.end(), column) != columns.end();
    };
    if (has(RosterColumn::givenName) != has(RosterColumn::familyName)) {
        return has(RosterColumn::givenName) ? RosterColumn::familyName : RosterColumn::givenName;
    }
    return has(RosterColumn::loginName) ? RosterColumn::displayName : RosterColumn::loginName;
}

} // namespace

std::vector<RosterColumn> rosterColumns(const std::vector<std::string>& headings) {
    std::vector<RosterColumn> columns;
    for (const std::string& heading : headings) {
        columns.push_back(columnOf(heading));
    }
    const RosterColumn meaning = meaningOfName(columns);
    std::replace(columns.begin(), columns.end(), RosterColumn::someName, meaning);
    return columns;
}

int knownHeadings(const std::vector<std::string>& headings) {
    return static_cast<int>(std::count_if(headings.begin(), headings.end(), [](const std::string& heading) {
        const RosterColumn column = columnOf(heading);
        return column != RosterColumn::unknown && column != RosterColumn::empty;
    }));
}

std::optional<RoleSet> rolesOfCell(const std::string& cell, const RoleWords& own) {
    QHash<QString, Role> more;
    for (const auto& [word, role] : own) {
        more.insert(plain(QString::fromStdString(word)), role);
    }
    RoleSet roles;
    for (const QString& written : wordsOf(cell)) {
        const QString word = plain(written);
        if (!roleWords().contains(word) && !more.contains(word)) {
            return std::nullopt;
        }
        roles.insert(roleWords().contains(word) ? roleWords().value(word) : more.value(word));
    }
    if (roles.empty() && more.contains(QString())) {
        roles.insert(more.value(QString()));
    }
    return roles.empty() ? std::nullopt : std::optional(roles);
}

std::vector<std::string> unknownRoleWords(const std::string& cell) {
    std::vector<std::string> unknown;
    const QStringList written = wordsOf(cell);
    for (const QString& word : written) {
        if (!roleWords().contains(plain(word))) {
            unknown.push_back(word.simplified().toStdString());
        }
    }
    if (written.isEmpty()) {
        unknown.emplace_back();
    }
    return unknown;
}

} // namespace chiron::database
