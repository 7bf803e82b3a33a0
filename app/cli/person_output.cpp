// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/person_output.h"

#include "cli/text_table.h"

namespace chiron::cli {

namespace {
QString text(const std::string& words) {
    return QString::fromStdString(words);
}
} // namespace

QString peopleText(const std::vector<database::Person>& people) {
    TextTable table({QStringLiteral(">id"), QStringLiteral("name"), QStringLiteral("display name"),
                     QStringLiteral("roles"), QStringLiteral("account")});
    for (const database::Person& person : people) {
        QStringList roles;
        for (const std::string& word : person.roles.tokens())
            roles << text(word);
        table.add({QString::number(person.id), text(person.name), text(person.displayName),
                   roles.join(QLatin1Char(',')),
                   !person.enabled             ? QStringLiteral("disabled")
                   : person.mustChangePassword ? QStringLiteral("password to be changed")
                                               : QStringLiteral("open")});
    }
    return table.toText();
}

} // namespace chiron::cli
