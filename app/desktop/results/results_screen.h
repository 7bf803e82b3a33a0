// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"
#include "desktop/results/results_data.h"
#include "report/report_data.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class QComboBox;
class QVBoxLayout;

namespace chiron::report {
class PlotView;
}

namespace chiron::desktop {

class AttemptsTable;
class ResponsiveRow;
class ResultsPart;
class StatePanel;
class WorkToken;

/// A person's results by exercise and level: a learning curve, and all attempts with links to their sessions.
/// A person can export a copy of their own data; for the results of others, trainers get a link to all of
/// that person's sessions. The screen opens at the selection in the place, or else at the last scored
/// attempt. The place is {exercise, level, metric}, plus {person, name} for another person.
/// Thread: GUI.
class ResultsScreen final : public Screen {
    Q_OBJECT
public:
    ResultsScreen(AppContext& context, const Place& place);
    ~ResultsScreen() override;

    QString title() const override;
    QString help() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;

    /// Writes everything stored about the person into a new folder there and says where it is, or why it
    /// could not be written.
    void exportTo(const QString& parent);

private:
    database::PersonId person() const; ///< whose results are shown
    bool isOwn() const;
    QWidget* ownData();
    void load();
    void showAttempts(std::vector<Attempt> attempts);
    void build();
    QWidget* filterRow();
    QComboBox* choice(const char* name, const QString& label, ResponsiveRow& row);
    void fillLevels();
    void fillMetrics();
    void showSelection();
    void showPart(const std::vector<Attempt>& attempts); ///< part of the chosen exercise
    std::vector<Attempt> selected() const;
    /// Of any exercise if `exercise` is empty; null if none was scored.
    const Attempt* lastScored(const std::string& exercise) const;
    bool asksFor(const QString& exercise) const; ///< the place names this exercise, and therefore its level
    report::MetricRow metricRow(const std::vector<Attempt>& attempts) const;
    void askExport();
    void openSession(database::SessionId session);

    StatePanel* m_panel = nullptr;
    std::vector<Attempt> m_attempts;
    QComboBox* m_exercise = nullptr;
    QComboBox* m_level = nullptr;
    QComboBox* m_metric = nullptr;
    QVBoxLayout* m_curveHolder = nullptr;
    report::PlotView* m_curve = nullptr;
    QWidget* m_partHolder = nullptr; ///< holds the part that is specific to one exercise
    /// The parts of the exercises chosen so far, by exercise; null if the exercise has none.
    std::map<std::string, ResultsPart*> m_parts;
    AttemptsTable* m_table = nullptr;
    std::shared_ptr<WorkToken> m_work;
    std::shared_ptr<WorkToken> m_export;
};

} // namespace chiron::desktop
