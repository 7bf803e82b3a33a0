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

/// Somebody's sessions: by exercise and level, a learning curve, every attempt a step away; of one's own a copy of all data, of others (for
/// trainers) the way to all their sessions. Opens at what the place asks for, else at the last scored attempt.
/// Place: {exercise, level, metric; person, name: of somebody else}. GUI thread.
class ResultsScreen final : public Screen {
    Q_OBJECT
public:
    ResultsScreen(AppContext& context, const Place& place);
    ~ResultsScreen() override;

    QString title() const override;
    QString help() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;

    /// Writes everything held about the person into a new folder there; tells where it is, or why not.
    void exportTo(const QString& parent);

private:
    database::PersonId person() const; ///< whose
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
    void showPart(const std::vector<Attempt>& attempts); ///< of the exercise that is chosen
    std::vector<Attempt> selected() const;
    const Attempt* lastScored(const std::string& exercise) const; ///< at any exercise where that is empty; null: none was scored
    bool asksFor(const QString& exercise) const;                  ///< the place names this exercise, and so its level
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
    QWidget* m_partHolder = nullptr; ///< of what one exercise alone has
    std::map<std::string, ResultsPart*> m_parts; ///< by exercise, of those that were chosen; null: it has none
    AttemptsTable* m_table = nullptr;
    std::shared_ptr<WorkToken> m_work;
    std::shared_ptr<WorkToken> m_export;
};

} // namespace chiron::desktop
