// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/procedure_words.h"

#include "psychophysics/procedures/procedure_catalogue.h"

#include <QCoreApplication>
#include <string>

namespace chiron::session_report {

QString procedureText(std::string_view marked) {
    return marked.empty() ? QString()
                          : QCoreApplication::translate("Procedures", std::string(marked).c_str());
}

QString procedureTitle(std::string_view id) {
    if (const psychophysics::ProcedureKind* kind = psychophysics::findProcedureKind(id))
        return procedureText(kind->words().title);
    return QString::fromStdString(std::string(id.substr(0, id.find('@'))))
        .replace(QLatin1Char('_'), QLatin1Char(' '));
}

QString procedureMeaning(std::string_view id) {
    const psychophysics::ProcedureKind* kind = psychophysics::findProcedureKind(id);
    return kind ? procedureText(kind->words().meaning) : QString();
}

QString wordTitle(const psychophysics::Parameter& row, std::string_view word) {
    for (const psychophysics::ParameterWord& each : row.words)
        if (each.word == word && !each.title.empty())
            return procedureText(each.title);
    return QString::fromStdString(std::string(word));
}

} // namespace chiron::session_report
