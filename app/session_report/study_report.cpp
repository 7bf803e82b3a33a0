// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/study_report.h"

#include "catalogue/study_json.h"
#include "report/page_writer.h"
#include "session_report/study_report_blocks.h"
#include "session_report/study_report_text.h"
#include "session_report/study_report_words.h"

namespace chiron::session_report {

namespace {

core::Result<StudyReportData> dataOf(database::StudyReader& reader, database::StudyNumber study,
                                     const std::string& language, const session::AnalysisChoices& choices) {
    auto record = reader.study(study);
    CHIRON_TRY(record);
    if (record->summary.state == database::StudyState::draft)
        return core::fail(core::ErrorCode::wrongUse,
                          "study " + std::to_string(study) + ": is a draft; a report is of a frozen study");
    auto design =
        catalogue::readStudy(QByteArray::fromStdString(record->designJson), "study " + std::to_string(study));
    CHIRON_TRY(design);
    auto analysis = session::analyseStudy(reader, study, design->seed, choices);
    CHIRON_TRY(analysis);
    auto participants = reader.participants(study);
    CHIRON_TRY(participants);
    auto answers = reader.questionnaireAnswers(study);
    CHIRON_TRY(answers);
    return StudyReportData{std::move(*analysis), std::move(*participants), std::move(*answers), language};
}

/// A separate function, because lupdate loses the context of the text in a function whose return type belongs
/// to another namespace.
QString heading() {
    return Words::tr("Study report");
}

report::PageFrame frameOf(const StudyReportData& data, const QString& site) {
    const database::StudySummary& summary = data.analysis.record.summary;
    const QString key = QString::fromStdString(summary.key);
    const QString sha256 = QString::fromStdString(summary.sha256);
    report::PageFrame frame;
    frame.heading = heading();
    frame.who = QStringLiteral("%1 · %2").arg(key, study_report_words::state(summary.state));
    frame.proof = sha256;
    frame.title = QStringLiteral("Chiron study report: %1, design %2").arg(key, sha256);
    frame.creator = QStringLiteral("Chiron");
    frame.site = site;
    return frame;
}

} // namespace

core::Result<void> writeStudyReport(const QString& path, database::StudyReader& reader,
                                    database::StudyNumber study, const report::PlotTheme& theme,
                                    const std::string& language, const session::AnalysisChoices& choices,
                                    const QString& site) {
    const auto data = dataOf(reader, study, language, choices);
    CHIRON_TRY(data);
    const StudyReportBlocks content(*data, theme, report::kPageBodyWidth);
    return report::writePages(path, frameOf(*data, site), content.blocks(), theme);
}

core::Result<void> paintStudyReport(QPagedPaintDevice& device, database::StudyReader& reader,
                                    database::StudyNumber study, const report::PlotTheme& theme,
                                    const std::string& language, const session::AnalysisChoices& choices,
                                    const QString& site) {
    const auto data = dataOf(reader, study, language, choices);
    CHIRON_TRY(data);
    const StudyReportBlocks content(*data, theme, report::kPageBodyWidth);
    if (!report::paintPages(device, frameOf(*data, site), content.blocks(), theme))
        return core::fail(core::ErrorCode::storage,
                          "study " + std::to_string(study) + ": the pages could not be drawn");
    return {};
}

} // namespace chiron::session_report
