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

/// Lets the person choose what moves the tool, with one tile per driver of the catalogue: the mouse,
/// connected devices, a scripted operator who demonstrates, or a trace file. Each tile shows the driver's
/// state. A trace file is read on a worker when it is chosen, and its errors are reported by row. Thread:
/// GUI.
class DeviceChooser final : public QWidget {
    Q_OBJECT
public:
    /// `kind`: the exercise whose operators and mechanism are offered; null if there is no demonstration.
    DeviceChooser(AppContext& context, const session::ExerciseKind* kind, QWidget* parent = nullptr);

    /// Sets the number of instruments of the chosen level. A trace must contain as many, so a chosen trace is
    /// read again if the number changes.
    void setTools(int tools);
    void setPlan(const TrainingPlan& plan); ///< adopts device, operator and trace of the plan
    void fillPlan(TrainingPlan& plan) const;
    QString hindrance() const; ///< why training cannot start with this choice; empty if it can

signals:
    void changed();

private:
    /// A driver that is offered, and its devices that are here.
    struct Offered {
        const devices::Driver* driver;
        std::vector<devices::FoundDevice> found;
        bool connected() const { return !found.empty() && !found.front().address.empty(); }
    };
    static std::vector<Offered> offeredInOrder();
    const Offered& offered() const; ///< the chosen one
    QString titleOf(const devices::Driver& driver) const;
    QString healthOf(const Offered& offered, const session::ExerciseKind* kind) const;
    QString demonstratedOn(const devices::Driver& driver, const session::ExerciseKind* kind) const;
    QWidget* addTile(int index, const QString& health);
    QWidget* demonstrationPage(const std::vector<std::string>& operators,
                               const devices::ForceMaps* forceMaps);
    void addForceMap(QVBoxLayout& column, const devices::ForceMaps& forceMaps);
    QWidget* tracePage();
    void showConnected();
    QStringList chosenAddresses() const;
    void show(const devices::Driver& driver);
    void askTrace();
    void checkTrace();
    void setTraceWords(const QString& words, const char* kind);
    const devices::Driver& driver() const;

    AppContext& m_context;
    session::PointerTool m_tool = session::PointerTool::point;
    int m_tools = 1;                ///< number of instruments of the chosen level
    std::vector<Offered> m_drivers; ///< one tile per driver, in this order
    QButtonGroup* m_group;
    QStackedWidget* m_pages;
    QComboBox* m_operator = nullptr;
    QComboBox* m_forceMap = nullptr; ///< null if the mechanism offers no choice
    QLabel* m_traceName = nullptr;
    QLabel* m_traceWords = nullptr;
    QVBoxLayout* m_connected = nullptr;  ///< of the page on which connected devices are chosen
    std::vector<QComboBox*> m_addresses; ///< one for each instrument
    QLabel* m_same = nullptr;            ///< says that two instruments have the same device
    QStringList m_wanted;                ///< addresses that a plan or the person chose
    QString m_traceFile;
    bool m_traceReady = false;
};

} // namespace chiron::desktop
