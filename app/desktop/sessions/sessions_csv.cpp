// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sessions/sessions_csv.h"

#include <QSaveFile>

namespace chiron::desktop {

namespace {

QByteArray field(const std::string& text) {
    QByteArray bytes = QByteArray::fromStdString(text);
    if (bytes.contains(',') || bytes.contains('"') || bytes.contains('\n') || bytes.contains('\r'))
        bytes = '"' + bytes.replace("\"", "\"\"") + '"';
    return bytes;
}

QByteArray line(const database::SessionSummary& s) {
    const QByteArray passed = !s.passed ? QByteArray() : QByteArray(*s.passed ? "true" : "false");
    const QByteArrayList fields{QByteArray::number(static_cast<qlonglong>(s.id)),
                                field(s.startedUtc),
                                field(s.personName),
                                field(s.exercise),
                                QByteArray::number(s.level),
                                QByteArray::fromStdString(std::string(database::token(s.state))),
                                passed,
                                s.felt ? "felt" : "shown",
                                s.familiarisation ? "true" : "false",
                                s.archived ? "true" : "false",
                                field(s.operatorName),
                                s.sealed ? QByteArray()
                                         : QByteArray::number(static_cast<double>(s.ticks) * 1e-3, 'f', 3),
                                s.gates > 0 ? QByteArray::number(s.gates) : QByteArray(),
                                s.gates > 0 ? QByteArray::number(s.gatesMet) : QByteArray(),
                                QByteArray::number(s.comments),
                                s.reviewed ? "true" : "false",
                                s.attempt > 0 ? QByteArray::number(s.attempt) : QByteArray()};
    return fields.join(',') + "\r\n";
}

} // namespace

QByteArray sessionsCsv(const std::vector<SessionRow>& rows) {
    QByteArray text = "session,started_utc,person,exercise,level,state,passed,device_class,familiarisation,"
                      "archived,operator,length_s,gates,gates_met,comments,reviewed,attempt\r\n";
    for (const SessionRow& row : rows)
        text += line(row.summary);
    return text;
}

core::Result<void> writeSessionsCsv(const std::vector<SessionRow>& rows, const QString& name) {
    QSaveFile file(name);
    const QByteArray text = sessionsCsv(rows);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
        return core::fail(core::ErrorCode::storage,
                          name.toStdString() + ": cannot be written: " + file.errorString().toStdString());
    return {};
}

} // namespace chiron::desktop
