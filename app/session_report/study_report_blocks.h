// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/block_maker.h"
#include "session/study/study_analysis.h"

#include <string>
#include <vector>

namespace chiron::session_report {

/// The data of a study's report.
struct StudyReportData {
    session::StudyAnalysis analysis;
    std::vector<database::Participant> participants;
    std::vector<database::QuestionnaireAnswer> answers;
    std::string language = "en"; ///< language of the design's texts

    /// True if conditions are identified by sealed codes: then neither their design nor its order may be
    /// shown.
    bool blind() const { return analysis.blind(); }
    /// Title, or sealed code, of a condition by its index in the analysis.
    QString conditionName(std::size_t condition) const;
    /// The attribute that differs in a condition, which determines the unit; not valid while blind, since
    /// nothing is then shown in units.
    psychophysics::Attribute attribute(std::size_t condition) const;
    /// Indices into the analysis in the order of the report: that of the design; ordered by sealed codes
    /// while blind.
    std::vector<std::size_t> conditionsInOrder() const;
};

/// Makes the blocks of a study's report, in reading order.
/// Thread: GUI.
class StudyReportBlocks : public report::BlockMaker {
public:
    StudyReportBlocks(const StudyReportData& data, const report::PlotTheme& theme, double width);

private:
    void addBanner();
    void addTitle();
    void addDesign();
    void addConditions();
    void addParticipants();
    void addCondition(std::size_t condition);
    void addGroup(std::size_t condition);
    void addWeberPlot(const session::AnalysedCondition& condition);
    void addRuns(std::size_t condition);
    void addCurves(std::size_t condition);
    void addApex(std::size_t condition);
    QString errorText(double mm, double percent) const;
    /// If three objects are ranked; see study_report_rankings.cpp.
    void addRankings(const session::AnalysedCondition& condition);
    void addComparisons(); ///< of every pair of conditions
    void addFidelity();
    void addQuality(); ///< replaces addFidelity() while runs are sealed
    void addQuestionnaires();
    QString answersTo(const std::vector<database::QuestionnaireAnswer>& answers,
                      const psychophysics::QuestionnaireItem& item) const;
    void addMuted(const QString& text);

    const StudyReportData& m_data;
};

} // namespace chiron::session_report
