// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/roster_words.h"

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

struct Word {
    RosterColumn column;
    const char* text;
};

constexpr Word kHeadings[] = {
    {RosterColumn::someName, "name"},
    {RosterColumn::someName, "όνομα"},
    {RosterColumn::loginName, "login"},
    {RosterColumn::loginName, "login name"},
    {RosterColumn::loginName, "loginname"},
    {RosterColumn::loginName, "log in name"},
    {RosterColumn::loginName, "user"},
    {RosterColumn::loginName, "user name"},
    {RosterColumn::loginName, "username"},
    {RosterColumn::loginName, "user id"},
    {RosterColumn::loginName, "account"},
    {RosterColumn::loginName, "account name"},
    {RosterColumn::loginName, "Anmeldename"},
    {RosterColumn::loginName, "Benutzername"},
    {RosterColumn::loginName, "Benutzer"},
    {RosterColumn::loginName, "Benutzerkennung"},
    {RosterColumn::loginName, "Nutzername"},
    {RosterColumn::loginName, "Kennung"},
    {RosterColumn::loginName, "Konto"},
    {RosterColumn::loginName, "Kontoname"},
    {RosterColumn::loginName, "όνομα χρήστη"},
    {RosterColumn::loginName, "χρήστης"},
    {RosterColumn::loginName, "όνομα σύνδεσης"},
    {RosterColumn::loginName, "λογαριασμός"},
    {RosterColumn::displayName, "display name"},
    {RosterColumn::displayName, "displayname"},
    {RosterColumn::displayName, "full name"},
    {RosterColumn::displayName, "fullname"},
    {RosterColumn::displayName, "name, first name"},
    {RosterColumn::displayName, "last name, first name"},
    {RosterColumn::displayName, "first name, last name"},
    {RosterColumn::displayName, "person"},
    {RosterColumn::displayName, "vollständiger Name"},
    {RosterColumn::displayName, "voller Name"},
    {RosterColumn::displayName, "Anzeigename"},
    {RosterColumn::displayName, "Name, Vorname"},
    {RosterColumn::displayName, "Nachname, Vorname"},
    {RosterColumn::displayName, "Vorname, Name"},
    {RosterColumn::displayName, "Vorname Nachname"},
    {RosterColumn::displayName, "Vor- und Nachname"},
    {RosterColumn::displayName, "ονοματεπώνυμο"},
    {RosterColumn::displayName, "πλήρες όνομα"},
    {RosterColumn::displayName, "όνομα και επώνυμο"},
    {RosterColumn::displayName, "όνομα επώνυμο"},
    {RosterColumn::displayName, "επώνυμο όνομα"},
    {RosterColumn::givenName, "first name"},
    {RosterColumn::givenName, "firstname"},
    {RosterColumn::givenName, "given name"},
    {RosterColumn::givenName, "forename"},
    {RosterColumn::givenName, "Vorname"},
    {RosterColumn::givenName, "Rufname"},
    {RosterColumn::familyName, "last name"},
    {RosterColumn::familyName, "lastname"},
    {RosterColumn::familyName, "surname"},
    {RosterColumn::familyName, "family name"},
    {RosterColumn::familyName, "Nachname"},
    {RosterColumn::familyName, "Familienname"},
    {RosterColumn::familyName, "Zuname"},
    {RosterColumn::familyName, "επώνυμο"},
    {RosterColumn::familyName, "επίθετο"},
    {RosterColumn::roles, "role"},
    {RosterColumn::roles, "roles"},
    {RosterColumn::roles, "Rolle"},
    {RosterColumn::roles, "Rollen"},
    {RosterColumn::roles, "Rolle(n)"},
    {RosterColumn::roles, "role(s)"},
    {RosterColumn::roles, "ρόλος"},
    {RosterColumn::roles, "ρόλοι"},
    {RosterColumn::roles, "ιδιότητα"},
    {RosterColumn::password, "password"},
    {RosterColumn::password, "initial password"},
    {RosterColumn::password, "Passwort"},
    {RosterColumn::password, "Kennwort"},
    {RosterColumn::password, "Startpasswort"},
    {RosterColumn::password, "Anfangspasswort"},
    {RosterColumn::password, "κωδικός"},
    {RosterColumn::password, "κωδικός πρόσβασης"},
    {RosterColumn::password, "αρχικός κωδικός"},
    {RosterColumn::password, "συνθηματικό"},
    {RosterColumn::group, "group"},
    {RosterColumn::group, "groups"},
    {RosterColumn::group, "class"},
    {RosterColumn::group, "cohort"},
    {RosterColumn::group, "Gruppe"},
    {RosterColumn::group, "Gruppen"},
    {RosterColumn::group, "Klasse"},
    {RosterColumn::group, "Kurs"},
    {RosterColumn::group, "Kohorte"},
    {RosterColumn::group, "Jahrgang"},
    {RosterColumn::group, "ομάδα"},
    {RosterColumn::group, "ομάδες"},
    {RosterColumn::group, "τάξη"},
    {RosterColumn::group, "τμήμα"},
};

struct RoleWord {
    Role role;
    const char* text;
};

// A punctuation mark between a word and its ending is equivalent to a space: "Ausbilder/in", "Ausbilder:in",
// "εκπαιδευτής/-τρια".
constexpr RoleWord kRoles[] = {
    {Role::trainee, "trainee"},
    {Role::trainee, "student"},
    {Role::trainee, "Lernende Person"},
    {Role::trainee, "Lernende"},
    {Role::trainee, "Lernender"},
    {Role::trainee, "Lernende/r"},
    {Role::trainee, "Auszubildende/r"},
    {Role::trainee, "Auszubildender"},
    {Role::trainee, "Auszubildende"},
    {Role::trainee, "Assistenzarzt"},
    {Role::trainee, "Assistenzärztin"},
    {Role::trainee, "Assistenzarzt/-ärztin"},
    {Role::trainee, "Teilnehmer"},
    {Role::trainee, "Teilnehmerin"},
    {Role::trainee, "Teilnehmer/in"},
    {Role::trainee, "Teilnehmende"},
    {Role::trainee, "Teilnehmende/r"},
    {Role::trainee, "Kursteilnehmer"},
    {Role::trainee, "Kursteilnehmerin"},
    {Role::trainee, "Kursteilnehmer/in"},
    {Role::trainee, "Studentin"},
    {Role::trainee, "Student/in"},
    {Role::trainee, "Studierende"},
    {Role::trainee, "Studierender"},
    {Role::trainee, "Studierende/r"},
    {Role::trainee, "resident"},
    {Role::trainee, "participant"},
    {Role::trainee, "learner"},
    {Role::trainee, "ειδικευόμενος/-η"},
    {Role::trainee, "ειδικευόμενος"},
    {Role::trainee, "ειδικευόμενη"},
    {Role::trainee, "συμμετέχων/-ουσα"},
    {Role::trainee, "συμμετέχων"},
    {Role::trainee, "συμμετέχουσα"},
    {Role::trainee, "φοιτητής/-τρια"},
    {Role::trainee, "φοιτητής"},
    {Role::trainee, "φοιτήτρια"},
    {Role::trainee, "εκπαιδευόμενος/-η"},
    {Role::trainee, "εκπαιδευόμενος"},
    {Role::trainee, "εκπαιδευόμενη"},
    {Role::trainer, "trainer"},
    {Role::trainer, "Trainerin"},
    {Role::trainer, "instructor"},
    {Role::trainer, "teacher"},
    {Role::trainer, "tutor"},
    {Role::trainer, "Kursleiter"},
    {Role::trainer, "Kursleiterin"},
    {Role::trainer, "Kursleiter/in"},
    {Role::trainer, "Dozent"},
    {Role::trainer, "Dozentin"},
    {Role::trainer, "Dozent/in"},
    {Role::trainer, "Lehrkraft"},
    {Role::trainer, "Ausbilder/in"},
    {Role::trainer, "Ausbilder"},
    {Role::trainer, "Ausbilderin"},
    {Role::trainer, "εκπαιδευτής/-τρια"},
    {Role::trainer, "εκπαιδευτής"},
    {Role::trainer, "εκπαιδεύτρια"},
    {Role::researcher, "researcher"},
    {Role::researcher, "Forschende Person"},
    {Role::researcher, "Forschende"},
    {Role::researcher, "Forschender"},
    {Role::researcher, "Forschende/r"},
    {Role::researcher, "Forscher/in"},
    {Role::researcher, "Forscher"},
    {Role::researcher, "Forscherin"},
    {Role::researcher, "ερευνητής/-τρια"},
    {Role::researcher, "ερευνητής"},
    {Role::researcher, "ερευνήτρια"},
    {Role::admin, "admin"},
    {Role::admin, "administrator"},
    {Role::admin, "Administration"},
    {Role::admin, "Administratorin"},
    {Role::admin, "Administrator/in"},
    {Role::admin, "διαχειριστής/-τρια"},
    {Role::admin, "διαχειριστής"},
    {Role::admin, "διαχειρίστρια"},
};

RosterColumn columnOf(const std::string& heading) {
    static const QHash<QString, RosterColumn> known = [] {
        QHash<QString, RosterColumn> words;
        for (const Word& word : kHeadings) {
            words.insert(plain(QString::fromUtf8(word.text)), word.column);
        }
        return words;
    }();
    const QString words = plain(QString::fromStdString(heading));
    return words.isEmpty() ? RosterColumn::empty : known.value(words, RosterColumn::unknown);
}

const QHash<QString, Role>& roleWords() {
    static const QHash<QString, Role> known = [] {
        QHash<QString, Role> words;
        for (const RoleWord& word : kRoles) {
            words.insert(plain(QString::fromUtf8(word.text)), word.role);
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
