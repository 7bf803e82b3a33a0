// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/tissue_content.h"

#include "catalogue/parameter_rows.h"
#include "core/units.h"
#include "simulation/palpation/tissue_surface.h"

#include <cmath>

namespace chiron::catalogue {

namespace {

using Tissue = simulation::TissueParameters;
using Row = ParameterRow<Tissue>;

/// Angles of a tissue are multiplied to radians; those of levels are divided (units::kDeg).
constexpr ContentUnit kDegOfTissue{"deg", 1.0, core::kPi / 180.0};

/// The ellipse on the surface that an elevation or a distractor covers.
template <class Ellipse> std::vector<ParameterRow<Ellipse>> ellipseRows() {
    using Each = ParameterRow<Ellipse>;
    return {Each::number(
                "x_mm", units::kMm, {-100, 100}, [](Ellipse& one) -> double& { return one.centre_m.x(); },
                "Middle, x in W.")
                .optional(),
            Each::number(
                "y_mm", units::kMm, {-100, 100}, [](Ellipse& one) -> double& { return one.centre_m.y(); },
                "Middle, y in W.")
                .optional(),
            Each::number(
                "radius_x_mm", units::kMm, {2, 150}, [](Ellipse& one) -> double& { return one.radii_m.x(); },
                "Half axis along its own x."),
            Each::number(
                "radius_y_mm", units::kMm, {2, 150}, [](Ellipse& one) -> double& { return one.radii_m.y(); },
                "Half axis along its own y."),
            Each::number("turn_deg", kDegOfTissue, {-180, 180}, &Ellipse::turn_rad,
                         "Its own x axis, turned so about z.")
                .optional()};
}

const std::vector<ParameterRow<simulation::SurfaceBump>>& bumpRows() {
    using Bump = simulation::SurfaceBump;
    static const auto kRows = [] {
        auto rows = ellipseRows<Bump>();
        rows.push_back(ParameterRow<Bump>::number("height_mm", units::kMm, {-50, 50}, &Bump::height_m,
                                                  "Above the plane in its middle; below 0: a furrow."));
        return rows;
    }();
    return kRows;
}

const std::vector<ParameterRow<simulation::TissueLayer>>& layerRows() {
    using Layer = simulation::TissueLayer;
    using Each = ParameterRow<Layer>;
    static const std::vector<Each> kRows{
        Each::identifier("name", &Layer::name, "What it is."),
        Each::number("thickness_mm", units::kMm, {0.1, 200}, &Layer::thickness_m,
                     "Of the last one without meaning.")
            .optional(),
        Each::number("modulus_kPa", units::kKPa, {0.5, 500}, &Layer::modulus_Pa, "Young's modulus.")};
    return kRows;
}

const std::vector<ParameterRow<simulation::StiffRegion>>& distractorRows() {
    using Region = simulation::StiffRegion;
    static const auto kRows = [] {
        auto rows = ellipseRows<Region>();
        rows.insert(rows.begin(), ParameterRow<Region>::identifier("name", &Region::name, "What it is."));
        rows.push_back(ParameterRow<Region>::number("gain", units::kPure, {-0.9, 5}, &Region::gain,
                                                    "How much stiffer its middle is; below 0: softer."));
        return rows;
    }();
    return kRows;
}

Row dampingRow(const char* key, Eigen::Index axis, const char* description) {
    return Row::number(
        key, units::kNs_per_m, {0, 20},
        [axis](Tissue& tissue) -> double& { return tissue.damping_Ns_per_m[axis]; }, description);
}

void turnFibres(Tissue& tissue, double turn_rad) {
    tissue.fibreDirection = {std::cos(turn_rad), std::sin(turn_rad), 0.0};
}

const std::vector<Row>& tissueRows() {
    using Contact = simulation::TissueContactLaw;
    using Lumps = simulation::LumpLaw;
    // Tissue has no id: the name tells only which numbers were filled in.
    static const std::vector<Row> kRows{
        Row::name("tissue",
                  "Name of the tissue in content/tissues whose properties hold where none is given here."),
        Row::number("plane_height_mm", units::kMm, {-50, 50},
                    within(&Tissue::shape, &simulation::SurfaceShape::planeHeight_m),
                    "Height of the plane that the elevations stand on, z in W."),
        Row::list("bumps", {0, 4}, bumpRows(), "One elevation, or a furrow.", "a number of a bump",
                  within(&Tissue::shape, &simulation::SurfaceShape::bumps),
                  "Elevations of the surface, added up: height·(1 - t²)³ where t < 1, t² = (x/rx)² + (y/ry)² "
                  "in its own axes."),
        Row::list("layers", {1, 4}, layerRows(), "One layer.", "a number of a layer", &Tissue::layers,
                  "From the surface down; the last goes on for ever."),
        Row::number("poisson", units::kPure, {0, 0.5}, &Tissue::poisson,
                    "Poisson's ratio; 0.5: does not give way in volume."),
        Row::number("contact_radius_mm", units::kMm, {1, 12}, &Tissue::contactRadius_m,
                    "Radius a of the finger pad's contact; half of a lump's depth at most."),
        Row::number("stiffness_N_per_m", units::kN_per_m, {0, 3000}, &Tissue::stiffness_N_per_m,
                    "Along the normal, P3's third of K; 0: from layers and contact radius."),
        Row::number("tangent_along_N_per_m", units::kN_per_m, {0, 3000}, &Tissue::tangentAlong_N_per_m,
                    "Sideways along the fibres, P3's first of K."),
        Row::number("tangent_across_N_per_m", units::kN_per_m, {0, 3000}, &Tissue::tangentAcross_N_per_m,
                    "Sideways across the fibres, P3's second of K."),
        Row::derived(
            "fibre_turn_deg", kDegOfTissue, {-180, 180}, &turnFibres,
            [](Tissue& tissue) { return std::atan2(tissue.fibreDirection.y(), tissue.fibreDirection.x()); },
            "Direction of the fibres: the x axis of W, turned so about z."),
        Row::number(
            "friction", units::kPure, {0, 2}, &Tissue::friction,
            "Coulomb coefficient mu; it clips the sideways force. A gloved, gelled finger slides easily."),
        dampingRow("damping_along_N_s_per_m", 0, "B along the fibres."),
        dampingRow("damping_across_N_s_per_m", 1, "B across them."),
        dampingRow("damping_normal_N_s_per_m", 2, "B along the normal."),
        Row::number("damping_depth_mm", units::kMm, {0.1, 10}, &Tissue::dampingDepth_m,
                    "Depth over which damping comes in."),
        Row::number("sinkage", units::kPure, {0, 1}, &Tissue::sinkage,
                    "λ: share of the depth by which the contact nears a lump."),
        Row::choice<Contact>(
            "contact", {{"anchored", Contact::anchored}, {"p3_recast", Contact::p3Recast}}, &Tissue::contact,
            "anchored: nearest surface point with a clipped bristle; p3_recast: the ray is cast again each "
            "tick, as P3 is worded. That makes energy; the passivity controller stands behind it."),
        Row::choice<Lumps>(
            "lump_law",
            {{"inclusion", Lumps::inclusion},
             {"second_surface", Lumps::secondSurface},
             {"stiffness_times_depth", Lumps::stiffnessTimesDepth}},
            &Tissue::lumps,
            "inclusion: felt before it is touched, with soft edges, from a potential; second_surface: P3's "
            "second surface below; stiffness_times_depth: as published elsewhere, makes energy."),
        Row::number("second_stiffness_N_per_m", units::kN_per_m, {10, 5000}, &Tissue::secondStiffness_N_per_m,
                    "Of a lump's own surface, for second_surface."),
        Row::list("distractors", {0, 4}, distractorRows(),
                  "One of them: stiffness times 1 + gain·(1 - t²)³, t as of bumps.",
                  "a number of a distractor", &Tissue::regions,
                  "Firmer (or softer) places that are normal anatomy."),
    };
    return kRows;
}

} // namespace

Tissue readTissue(const ObjectReader& json) {
    Tissue out;
    readParameters(tissueRows(), json, QStringLiteral("a property of a tissue"), out);
    return out;
}

QByteArray tissuePropertiesSchema() {
    return parametersSchema({"Properties of a tissue",
                             "What a palpating finger touches: shape, layers, contact (P3; models.md §3). A "
                             "level names a tissue of content/tissues and may change any property.",
                             JsonLayout::itemPerLine},
                            tissueRows());
}

void checkTissue(const Tissue& tissue, const QString& path, Problems& problems) {
    if (tissue.layers.empty())
        problems.push_back(
            {memberPath(path, "layers"), QStringLiteral("none"), QStringLiteral("one at least")});
    const double unique_m = simulation::TissueSurface(tissue.shape).deepestUnique_m();
    if (unique_m <= tissue.contactRadius_m)
        problems.push_back(
            {memberPath(path, "bumps"),
             QStringLiteral("a surface that bends round %1 mm").arg(units::kMm.perSi * unique_m, 0, 'g', 3),
             QStringLiteral("gentler: more than the finger's own pad, contact_radius_mm = %1 mm")
                 .arg(units::kMm.perSi * tissue.contactRadius_m, 0, 'g', 3)});
}

} // namespace chiron::catalogue
