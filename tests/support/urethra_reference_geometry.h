// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/urethra_anatomy.h"
#include "simulation/geometry/urethra/urethra_surface.h"

#include <vector>

namespace chiron::testing {

/// The drawn urethra straight from the equations of models.md §1.1, plain and slow: every curve by de
/// Casteljau from its points, every time. Shares plain data with the product and none of its code.
class UrethraReferenceGeometry {
public:
    UrethraReferenceGeometry(const simulation::UrethraAnatomy& anatomy,
                             const simulation::Endoscope& endoscope,
                             const simulation::UrethraMeshSettings& mesh);

    void deform(const simulation::UrethraDeformation& deformation);
    core::Vec3 at(double s, double angle) const; ///< the drawn surface
    core::Vec3 exactAt(double s,
                       double angle) const; ///< the tube that it interpolates, with the endoscope in it
    double length() const { return m_length; }
    double arcLength(double z) const;

private:
    using Points = std::vector<core::Vec3>;
    struct Section {
        double s = 0.0;
        Points points;
        bool onRest = false; ///< its curves are those of the resting surface
        Points restSlopes;   ///< then also the slopes along, per length of the resting chord
    };
    using Sections = std::vector<Section>;

    struct Frame {
        core::Vec3 p, n;
    };
    Frame frame(double s) const;
    double baseRadius(double s) const;
    core::Vec3 tube(double s, double angle, bool withScope) const;
    Section circle(double s, bool withScope) const;
    Section endOnRest(double s) const;
    double nudged(double s) const;
    core::Vec3 along(const Sections& sections, std::size_t span, std::size_t column, double u) const;
    core::Vec3 slopeAt(const Sections& sections, std::size_t section, std::size_t column) const;
    core::Vec3 around(const Section& section, std::size_t column, double v) const;
    core::Vec3 coons(const Sections& sections, double s, double angle) const;

    simulation::UrethraAnatomy m_anatomy;
    simulation::Endoscope m_scope;
    simulation::UrethraMeshSettings m_mesh;
    simulation::UrethraDeformation m_now;
    double m_length = 0.0;
    Sections m_rest;
    Sections m_deformed;
};

} // namespace chiron::testing
