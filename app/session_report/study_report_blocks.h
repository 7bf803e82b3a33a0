// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/block_maker.h"
#include "session/study/study_analysis.h"

#include <string>
#include <vector>

namespace chiron::session_report {

/// What a study's report is made of.
struct StudyReportData {
    session::StudyAnalysis analysis;
    std::vector<database::Participant> participants;
    std::vector<database::QuestionnaireAnswer> answers;
    std::string language = "en"; ///< of the design's texts

    /// Whether conditions go by sealed codes: then neither their design nor the order in which it lists them is told.
    bool blind() const { return analysis.blind(); }
    /// Title, or sealed code, of a condition by its place in the analysis.
    QString conditionName(std::size_t condition) const;
    /// What differs in a condition, for its unit; of no use while blind, where nothing is told in units.
    psychophysics::Attribute attribute(std::size_t condition) const;
    /// Places in the analysis in the order they are told: the design's; while blind by sealed code.
    std::vector<std::size_t> conditionsInOrder() const;
};

/// Makes the blocks of a study's report, in reading order. GUI thread.
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
    void addRankings(const session::AnalysedCondition& condition); ///< where three are ranked; study_report_rankings.cpp
    void addComparisons(); ///< of conditions, two by two
    void addFidelity();
    void addQuality(); ///< in place of it while runs are sealed
    void addQuestionnaires();
    QString answersTo(const std::vector<database::QuestionnaireAnswer>& answers, const psychophysics::QuestionnaireItem& item) const;
    void addMuted(const QString& text);

    const StudyReportData& m_data;
};

} // namespace chiron::session_report
