// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The exercises of the application, one line each: every part of an exercise is reached from its line. Five
// lists are made from these lines, one in each library that has a part of an exercise, because none of these
// libraries may link all others: session_catalogue.cpp (session), report_catalogue.cpp (session_report),
// face_catalogue.cpp (desktop), flat_catalogue.cpp (scene3d) and scene_catalogue.cpp (the library with Qt3D).
// Each of them includes the headers of the parts that it makes; without one of them it does not compile. The
// lists of the floors below are curriculum/catalogue/exercise_contents.cpp (levels),
// curriculum/scoring/metric_catalogue.cpp (metrics) and modules/exercises/law_catalogue.cpp (laws).

namespace chiron::simulation {
struct ComparisonParameters;
struct ElasticTubeParameters;
struct ObjectHandlingParameters;
struct PalpationParameters;
struct SphereApexParameters;
struct UrethraInsertionParameters;
} // namespace chiron::simulation

namespace chiron::session {
class ComparisonKind;
class ElasticTubeKind;
class ObjectHandlingKind;
class PalpationKind;
class SphereApexKind;
class UrethraInsertionKind;
} // namespace chiron::session

namespace chiron::session_report {
class ComparisonReporter;
class ElasticTubeReporter;
class ObjectHandlingReporter;
class PalpationReporter;
class SphereApexReporter;
class UrethraInsertionReporter;
} // namespace chiron::session_report

namespace chiron::desktop {
class ComparisonFace;
class ElasticTubeFace;
class ObjectHandlingFace;
class PalpationFace;
class SphereApexFace;
class UrethraInsertionFace;
} // namespace chiron::desktop

namespace chiron::scene3d {
class ApexContent;
class EndoscopeStage;
class FlatApex;
class FlatComparison;
class FlatHandling;
class FlatPalpation;
class FlatTube;
class FlatUrethra;
class HandlingContent;
class PalpationContent;
class SceneStage;
class TubeContent;
} // namespace chiron::scene3d

namespace chiron::exercises {

/// The parts of one exercise.
template <class KindOf, class ParametersOf, class ReporterOf, class FaceOf, class FlatOf, class StageOf,
          class ContentOf>
struct Parts {
    using Kind = KindOf;             ///< session::ExerciseKind: how it is run
    using Parameters = ParametersOf; ///< of a level
    using Reporter = ReporterOf;     ///< session_report::ExerciseReporter: what reports say
    using Face = FaceOf;             ///< desktop::ExerciseFace: what screens show
    using Flat = FlatOf;             ///< scene3d::IFlatContent: the flat drawing
    using Stage = StageOf;           ///< scene3d::IStage: the drawing in 3D; void: there is none
    using Content = ContentOf;       ///< scene3d::ISceneContent in a SceneStage; void: the stage needs none
};

struct SphereApex
    : Parts<session::SphereApexKind, simulation::SphereApexParameters, session_report::SphereApexReporter,
            desktop::SphereApexFace, scene3d::FlatApex, scene3d::SceneStage, scene3d::ApexContent> {
    static constexpr const char* kId = "sphere_apex";
};
struct UrethraInsertion : Parts<session::UrethraInsertionKind, simulation::UrethraInsertionParameters,
                                session_report::UrethraInsertionReporter, desktop::UrethraInsertionFace,
                                scene3d::FlatUrethra, scene3d::EndoscopeStage, void> {
    static constexpr const char* kId = "urethra_insertion";
};
struct ElasticTube
    : Parts<session::ElasticTubeKind, simulation::ElasticTubeParameters, session_report::ElasticTubeReporter,
            desktop::ElasticTubeFace, scene3d::FlatTube, scene3d::SceneStage, scene3d::TubeContent> {
    static constexpr const char* kId = "elastic_tube";
};
struct ObjectHandling : Parts<session::ObjectHandlingKind, simulation::ObjectHandlingParameters,
                              session_report::ObjectHandlingReporter, desktop::ObjectHandlingFace,
                              scene3d::FlatHandling, scene3d::SceneStage, scene3d::HandlingContent> {
    static constexpr const char* kId = "object_handling";
};
struct Palpation
    : Parts<session::PalpationKind, simulation::PalpationParameters, session_report::PalpationReporter,
            desktop::PalpationFace, scene3d::FlatPalpation, scene3d::SceneStage, scene3d::PalpationContent> {
    static constexpr const char* kId = "palpation";
};
/// The task of studies, which nobody trains.
struct Comparison
    : Parts<session::ComparisonKind, simulation::ComparisonParameters, session_report::ComparisonReporter,
            desktop::ComparisonFace, scene3d::FlatComparison, void, void> {
    static constexpr const char* kId = "comparison";
};

template <class... Exercises> struct List {};

/// All of them, in the order in which people read of them.
using All = List<SphereApex, UrethraInsertion, ElasticTube, ObjectHandling, Palpation, Comparison>;

} // namespace chiron::exercises
