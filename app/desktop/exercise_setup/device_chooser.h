// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "desktop/training/training_plan.h"
#include "session/exercise_kind.h"

#include <QWidget>
#include <string>
#include <vector>

class QButtonGroup;
class QComboBox;
class QFrame;
class QLabel;
class QStackedWidget;
class QVBoxLayout;

namespace chiron::desktop {

class AppContext;

/// What moves the tool, a tile for each driver of the catalogue: the mouse, a scripted operator who demonstrates, or a trace file; each with how it is. A trace is
/// read on a worker when it is chosen, and its faults are named by row. GUI thread.
class DeviceChooser final : public QWidget {
    Q_OBJECT
public:
    /// `kind`: of the exercise, whose operators and mechanism are offered; null: nobody demonstrates it.
    DeviceChooser(AppContext& context, const session::ExerciseKind* kind, QWidget* parent = nullptr);

    /// Of the level that is chosen: a trace has to hold as many. Reads a chosen trace again where it changes.
    void setTools(int tools);
    void setPlan(const TrainingPlan& plan); ///< takes device, operator and trace over
    void fillPlan(TrainingPlan& plan) const;
    bool ready() const; ///< what is chosen can begin

signals:
    void changed();

private:
    QString titleOf(const devices::Driver& driver) const;
    QString healthOf(const devices::Driver& driver, const session::ExerciseKind* kind) const;
    QString demonstratedOn(const session::ExerciseKind* kind) const;
    QWidget* addTile(int index, const QString& health);
    QWidget* demonstrationPage(const std::vector<std::string>& operators, bool forceMap);
    void addForceMap(QVBoxLayout& column);
    QWidget* tracePage();
    void show(const devices::Driver& driver);
    void askTrace();
    void checkTrace();
    void setTraceWords(const QString& words, const char* kind);
    const devices::Driver& driver() const;

    AppContext& m_context;
    session::PointerTool m_tool = session::PointerTool::point;
    int m_tools = 1; ///< instruments of the level that is chosen
    std::vector<const devices::Driver*> m_drivers; ///< a tile each, in this order
    QButtonGroup* m_group;
    QStackedWidget* m_pages;
    QComboBox* m_operator = nullptr;
    QComboBox* m_forceMap = nullptr; ///< null where the mechanism has one way only
    QLabel* m_traceName = nullptr;
    QLabel* m_traceWords = nullptr;
    QString m_traceFile;
    bool m_traceReady = false;
};

} // namespace chiron::desktop
