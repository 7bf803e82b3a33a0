// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "haptics/display_state.h"

#include <QPointF>
#include <QWidget>
#include <array>
#include <cstdint>

namespace chiron::desktop {

/// The positions of the objects, and the geometry for taking hold of them.
/// Unit: m.
/// Frame: W (world).
struct PlacesSetup {
    int places = 3;
    double spacing_m = 0.04;
    double padRadius_m = 0.009;
    double gripHeight_m = 0.03; ///< simulation::gripZone
    double gripRadius_m = 0.006;
    /// A line at each object, below which the tool lets go of it (simulation::letGoHeight_m); 0: none.
    double letGoHeight_m = 0.0;
    bool hooked = false; ///< the tool takes hold of it (a tube, an object) instead of pressing it (a pad)
    bool lifted = false; ///< what is held leaves the table (an object), instead of being stretched (a tube)
    bool visible = true; ///< the objects are drawn; otherwise only their positions
    QStringList names;   ///< labels below the positions: "1" ...
};

/// The participant's view: positions that all look alike, the tool, and which objects were touched. Nothing
/// drawn depends on a stimulus: objects do not deform, and the tool is drawn at the surface. An object that
/// is lifted moves with the tool, whatever it weighs. Thread: GUI.
class PlacesView final : public QWidget {
    Q_OBJECT
public:
    PlacesView(const Theme& theme, const PlacesSetup& setup, QWidget* parent = nullptr);

    struct Now {
        bool objects = false;      ///< the objects are present
        std::uint32_t touched = 0; ///< one bit per place
        int place = -1;            ///< the place being touched; -1: none
        bool feltNothing = false;  ///< the device renders no force, so force is shown as a bar
        double force_N = 0.0;
        double limit_N = 4.0; ///< the largest force allowed, marked at the bar
        double lift_m = 0.0;  ///< of the held object above the table; below 0 it stands on the table
    };
    void show(const haptics::DisplayState& state, const Now& now);
    /// Marks at the places ("1st" of a ranking); empty strings for none.
    void setMarks(const QStringList& marks);
    /// Height (m) above the table at which the object of a place is drawn; 0: it stands there.
    double drawnHeight_m(int place) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QPointF project(double x_m, double y_m, double z_m) const;
    double pixelsPerMetre(double y_m) const;
    void paintField(QPainter& painter) const;
    void paintPlace(QPainter& painter, int place) const;
    void paintPad(QPainter& painter, double x_m) const;
    void paintHook(QPainter& painter, double x_m, bool held) const;
    void paintObject(QPainter& painter, int place) const;
    bool isCarried(int place) const {
        return m_setup.lifted && m_now.objects && place >= 0 && m_now.place == place;
    }
    void paintLetGo(QPainter& painter, double x_m) const;
    QFont nameFont(double width_px) const;
    void paintName(QPainter& painter, int place) const;
    const std::array<double, 3>& toolAt() const; ///< where the tool is drawn, W
    void paintToolShadow(QPainter& painter) const;
    void paintTool(QPainter& painter) const;
    void paintForce(QPainter& painter) const;

    const Theme& m_theme;
    PlacesSetup m_setup;
    haptics::ToolDisplay m_tool;
    bool m_haveTool = false;
    std::array<double, 3> m_taken_m{}; ///< where the tool was when it took hold of the held object, W
    Now m_now;
    QStringList m_marks;
};

} // namespace chiron::desktop
