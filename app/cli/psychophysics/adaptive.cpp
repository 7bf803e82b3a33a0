// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"
#include "catalogue/procedure_reader.h"
#include "cli/cli_errors.h"
#include "cli/input_file.h"
#include "cli/psychophysics/adaptive_lines.h"
#include "cli/psychophysics/handlers.h"
#include "cli/session_output.h"
#include "psychophysics/procedures/procedure_catalogue.h"

#include <QJsonDocument>
#include <cstdio>
#include <iostream>
#include <string>
#include <variant>

namespace chiron::cli {

namespace {

using namespace psychophysics;

core::Result<void> printLine(const QJsonObject& json) {
    const QByteArray line = QJsonDocument(json).toJson(QJsonDocument::Compact) + '\n';
    const auto size = static_cast<std::size_t>(line.size());
    if (std::fwrite(line.constData(), 1, size, stdout) != size || std::fflush(stdout) != 0)
        return stdoutBroke();
    return {};
}

QStringList dimensionsOf(const ProcedureSpec& spec) {
    QStringList names;
    for (const Parameter& row : kindFor(spec).rows()) {
        const ParameterValue value = row.get(spec);
        if (const auto* grids = std::get_if<StimulusGrids>(&value))
            for (const auto& dimension : *grids)
                names << QString::fromStdString(dimension.first);
    }
    return names;
}

bool ordersThree(const ProcedureSpec& spec) {
    return kindFor(spec).ordersThree(spec);
}

/// Applies one line to the procedure. The procedure is unchanged after a failure.
/// Errors: badInput; wrongUse (undo without an answer to undo).
core::Result<void> take(Procedure& procedure, const AdaptiveLine& line) {
    if (line.kind == AdaptiveLine::Kind::undo)
        return procedure.undo();
    if (line.kind == AdaptiveLine::Kind::spoiled) {
        procedure.spoiled();
        return {};
    }
    return procedure.record(line.outcome, line.presented ? *line.presented : procedure.next().stimulus);
}

tl::unexpected<core::Error> atLine(int number, const core::Error& error) {
    return badInput(
        QStringLiteral("stdin line %1: %2").arg(number).arg(QString::fromStdString(error.message)));
}

/// Processes and answers each line before it reads the next one. Once the procedure is done, further answers
/// change nothing and are marked as ignored.
core::Result<void> answerLines(Procedure& procedure, bool orders, const QStringList& names) {
    const auto dimensions = static_cast<std::size_t>(names.isEmpty() ? 1 : names.size());
    std::string text;
    for (int number = 1; std::getline(std::cin, text); ++number) {
        // Answers that end in a carriage return alone would be read as one line.
        if (const auto at = text.find('\r'); at != std::string::npos && at + 1 < text.size())
            return atLine(
                number,
                {core::ErrorCode::badInput,
                 "a carriage return within the line: expected lines that end in a line feed, or in both"});
        // An answer that was cut off may read as a different answer.
        if (std::cin.eof() && !text.ends_with('\r'))
            return atLine(number,
                          {core::ErrorCode::badInput, "the last line has no line feed: expected one after "
                                                      "every answer, or the answer was cut off"});
        const QString words = QString::fromStdString(text);
        if (words.trimmed().isEmpty())
            continue;
        const auto line = parseAdaptiveLine(words, procedure.outcomes(), orders, dimensions);
        if (!line)
            return atLine(number, line.error());
        const bool ignored = procedure.done() && line->kind != AdaptiveLine::Kind::undo;
        if (!ignored)
            if (auto taken = take(procedure, *line); !taken)
                return atLine(number, taken.error());
        QJsonObject state = adaptiveState(procedure, names);
        if (ignored) {
            state.insert("ignored", true);
            tell(QStringLiteral("stdin line %1: the procedure is done; this answer changes nothing")
                     .arg(number));
        }
        CHIRON_TRY(printLine(state));
    }
    if (std::cin.bad())
        return core::fail(core::ErrorCode::storage,
                          "stdin: broke off; expected it to be readable to its end");
    return {};
}

} // namespace

core::Result<CommandOutput> runAdaptive(const Arguments& arguments) {
    const auto seed = arguments.seed(QStringLiteral("seed"), 1);
    CHIRON_TRY(seed);
    // One byte more than readProcedure() accepts, so that its message can say where the limit was exceeded.
    constexpr qint64 kLargest = (16 << 20) + 1;
    const QString path = arguments.value(QStringLiteral("procedure"));
    const auto bytes = readInputFile(path, kLargest);
    CHIRON_TRY(bytes);
    const auto content = catalogue::findContentDirectory();
    CHIRON_TRY(content);
    const auto schema =
        catalogue::readSchema(QString::fromStdString(*content) + "/schema", QStringLiteral("procedure"));
    CHIRON_TRY(schema);
    const auto spec = catalogue::readProcedure(*bytes, path.toStdString(), *schema);
    CHIRON_TRY(spec);
    const auto procedure = makeProcedure(*spec, *seed);
    if (!procedure)
        return badInput(
            QStringLiteral("%1: %2").arg(path, QString::fromStdString(procedure.error().message)));
    const QStringList names = dimensionsOf(*spec);
    QJsonObject first = adaptiveState(**procedure, names);
    first.insert("procedure", QString::fromUtf8((*procedure)->id().data(),
                                                static_cast<qsizetype>((*procedure)->id().size())));
    CHIRON_TRY(printLine(first));
    CHIRON_TRY(answerLines(**procedure, ordersThree(*spec), names));
    QJsonObject last = adaptiveState(**procedure, names);
    last.insert("final", true);
    CHIRON_TRY(printLine(last));
    return CommandOutput{};
}

} // namespace chiron::cli
